/**
 * A ROS 1 client in pure Java. {@link org.robotui.ros.RosNode} is the way in: it publishes, subscribes, offers and
 * calls services, reads parameters and shows the graph, over the same wire protocols as roscpp and rospy. It stays
 * usable while the master or any peer is away, and reports the state of every link. How a call ended is an
 * {@link org.robotui.net.call.Outcome}.
 *
 * <p>Usable alone: it needs {@code org.robotui.net}, what the protocol libraries share, {@code org.robotui.message},
 * what messages are, {@code org.robotui.geometry} and SLF4J.
 */
package org.robotui.ros;
