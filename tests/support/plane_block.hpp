/// A scene in space whose solution is plane.
#pragma once

namespace ixos::test {

/// A block of depth 3 between smooth walls, which falls onto a wall.
inline const char* const plane_block = R"x(<ParameterList name="Block">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
    <ParameterList name="Box"><Parameter name="Dimension" type="int" value="3"/>
      <Parameter name="Lower" type="Array(double)" value="{0, -1, 0.4}"/>
      <Parameter name="Lengths" type="Array(double)" value="{2, 3, 1}"/>
      <Parameter name="Divisions" type="Array(int)" value="{8, 6, 4}"/></ParameterList>
    <ParameterList name="Sets"><ParameterList name="contact">
      <Parameter name="From" type="string" value="bottom"/>
      <Parameter name="Upper" type="Array(double)" value="{1.5, 2, 9}"/></ParameterList></ParameterList></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Rubber"/></ParameterList>
  <ParameterList name="Interactions"><ParameterList name="Wall">
    <Parameter name="Side Set" type="string" value="contact"/></ParameterList></ParameterList>
  <ParameterList name="Boundary Conditions">
    <ParameterList name="Front"><Parameter name="Node Set" type="string" value="front"/>
      <Parameter name="Components" type="string" value="y"/></ParameterList>
    <ParameterList name="Back"><Parameter name="Node Set" type="string" value="back"/>
      <Parameter name="Components" type="string" value="y"/></ParameterList>
    <ParameterList name="Left"><Parameter name="Node Set" type="string" value="left"/>
      <Parameter name="Components" type="string" value="xy"/></ParameterList></ParameterList>
  <ParameterList name="Initial Conditions">
    <Parameter name="Velocity" type="Array(double)" value="{0, 0, -20}"/></ParameterList>
  <ParameterList name="Time Integrator"><Parameter name="Type" type="string" value="Average Vector Field"/>
    <ParameterList name="Time Step Control">
      <Parameter name="Final Time" type="double" value="0.02"/>
      <Parameter name="Time Step" type="double" value="0.0005"/></ParameterList></ParameterList>
  <ParameterList name="Output">
    <Parameter name="Reactions" type="Array(string)" value="{left, front}"/>
    <ParameterList name="Probes"><ParameterList name="force">
      <Parameter name="Point" type="Array(double)" value="{2, 0, 1.4}"/></ParameterList></ParameterList></ParameterList>
</ParameterList>)x";

}  // namespace ixos::test
