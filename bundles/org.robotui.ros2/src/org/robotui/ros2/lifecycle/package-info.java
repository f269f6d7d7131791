/** Nodes with a life cycle: in which state they are, and changing it. */
package org.robotui.ros2.lifecycle;
