package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * An uncertain pose with time and frame ({@code geometry_msgs/PoseWithCovarianceStamped}).
 *
 * @param header time and frame
 * @param pose the pose
 */
@MessageType("geometry_msgs/PoseWithCovarianceStamped")
public record PoseWithCovarianceStamped(Header header, PoseWithCovariance pose) {}
