/**
 * Names of ROS 2 and what they are called in DDS: checked, resolved as seen from a node, remapped, mangled and
 * demangled. All values; nothing here waits or knows a network.
 */
package org.robotui.ros2.name;
