"""Numbers for histories of a force: its peak, its oscillation, its distance from another run's; and the detachment.

Times and values are arrays, a value a row. What a history does not tell is NaN."""
import numpy as np

from results import within

FEWEST = 5  # rows a window must hold: a parabola through fewer would follow them


def mean(times, values):
    """Mean over time (trapezoid rule), so that rows count by their steps."""
    return float(np.sum(np.diff(times) * (values[1:] + values[:-1])) / (2 * (times[-1] - times[0])))


def rms(times, values):
    """Root of the mean square over time."""
    return mean(times, values ** 2) ** 0.5


def peak(times, values):
    """Time and value of the largest value."""
    row = int(np.argmax(values))
    return times[row], values[row]


PARTS = (0.5, "start of peeling"), (0.1, "peeling"), (0.0, "snap-off")


def event(contact, largest):
    """The event at a contact measure: with half of the largest contact left, peeling starts; the last tenth snaps off."""
    if not largest > 0 or np.isnan(contact):
        return None
    return next((name for share, name in PARTS if contact > share * largest), "detached")


def event_peak(name, times, values, row_times, contact):
    """Time and value of the largest value while the contact is in that event; NaN where it never is."""
    largest = np.nanmax(contact, initial=0.0)
    there = [event(part, largest) == name for part in np.interp(times, row_times, contact)]
    return peak(times[there], values[there]) if any(there) else (np.nan, np.nan)


def detachment(times, contact):
    """First time from which on the contact measure is zero until the end; NaN where it never was more, or ends so."""
    touching = np.flatnonzero(contact > 0)
    detached = len(touching) and touching[-1] + 1 < len(times) and not np.isnan(contact[touching[-1] + 1:]).any()
    return times[touching[-1] + 1] if detached else np.nan


def covered(times, interval):
    """Whether the rows reach both ends of an interval to within a step, and two or more lie in it."""
    if np.count_nonzero(within(times, interval)) < 2:
        return False
    step = np.diff(times).max() * (1 + 1e-9)
    return times[0] - step <= interval[0] and interval[1] <= times[-1] + step


def smooth(times, values, interval, window):
    """The smooth part of a history at its rows in an interval; NaN where a window holds fewer than FEWEST rows.

    At the time t it is the value at t of the parabola that fits, by least squares, the rows within t - window/2 and
    t + window/2, also those outside the interval; near the ends of the history only the side that is there."""
    result = []
    for time in times[within(times, interval)]:
        near = within(times, (time - window / 2, time + window / 2))
        place = (times[near] - time) / window
        fits = len(place) >= FEWEST
        result.append(np.linalg.lstsq(np.vander(place, 3), values[near], rcond=None)[0][-1] if fits else np.nan)
    return np.array(result)


def oscillation(times, values, interval, window):
    """How much a history oscillates in an interval: (absolute, relative to the size of its mean there).

    The root of the mean square over the interval of the history minus its smooth part (above). What lasts shorter
    than about window/5 counts in full, what lasts longer than the window hardly: a sine of the period window/5 or less
    gives its amplitude over sqrt 2 up to 10 %, a parabola gives 0. NaN where the history does not cover the interval or
    a window holds fewer than FEWEST rows: steps that long do not show such oscillations."""
    if not covered(times, interval):
        return np.nan, np.nan
    inside = within(times, interval)
    result = rms(times[inside], values[inside] - smooth(times, values, interval, window))
    return result, over(result, abs(mean(times[inside], values[inside])))


def deviation(times, values, reference_times, reference_values, interval=None):
    """Distance of a history from a reference: (absolute, relative to the reference's root of the mean square).

    The root of the mean square over the interval (all that both have, if None) of the difference, the reference taken
    at the history's own times by linear interpolation. NaN where either does not cover the interval."""
    both = max(times[0], reference_times[0]), min(times[-1], reference_times[-1])
    if interval and not (covered(times, interval) and covered(reference_times, interval)):
        return np.nan, np.nan
    inside = within(times, (max(both[0], interval[0]), min(both[1], interval[1])) if interval else both)
    if np.count_nonzero(inside) < 2:
        return np.nan, np.nan
    times = times[inside]
    reference = np.interp(times, reference_times, reference_values)
    result = rms(times, values[inside] - reference)
    return result, over(result, rms(times, reference))


def over(value, scale):
    """A ratio; NaN where there is nothing to divide by."""
    return value / scale if scale > 0 else np.nan
