/**
 * A ROS 1 client in pure Java. {@link org.robotui.ros.RosNode} is the way in: it publishes, subscribes, offers and
 * calls services, reads parameters and shows the graph, over the same wire protocols as roscpp and rospy. It stays
 * usable while the master or any peer is away, and reports the state of every link.
 */
package org.robotui.ros;
