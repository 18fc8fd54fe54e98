"""A study's report as its tests read it."""
import html.parser


class Page(html.parser.HTMLParser):
    """A report's tags, balanced, and its text; its tables as rows of cells."""

    def __init__(self, folder):
        super().__init__()
        self.open, self.tags, self.words, self.tables = [], [], [], []
        self.source = (folder / "report.html").read_text(encoding="utf-8")
        self.feed(self.source)
        self.close()
        assert not self.open, self.open
        self.text = " ".join("".join(self.words).split())

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in ("meta", "img", "br"):
            self.open.append(tag)
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self.tables[-1][-1].append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.words.append(data if "style" not in self.open else "")
        if "td" in self.open or "th" in self.open:
            self.tables[-1][-1][-1] += ("" if "small" not in self.open else "; ") + data

    def table(self, *words):
        """The only table whose header begins with these words: its other rows."""
        (_, *rows), = [rows for rows in self.tables if rows[0][:len(words)] == list(words)]
        return rows
