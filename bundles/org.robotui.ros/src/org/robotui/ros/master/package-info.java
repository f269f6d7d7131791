/** A ROS master with parameter server, for robots and simulators that bring their own; stock ROS tools work with it. */
package org.robotui.ros.master;
