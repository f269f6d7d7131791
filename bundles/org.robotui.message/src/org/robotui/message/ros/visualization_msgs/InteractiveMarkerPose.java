package org.robotui.message.ros.visualization_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Where an interactive marker is now ({@code visualization_msgs/InteractiveMarkerPose}).
 *
 * @param header time and frame
 * @param pose where it is
 * @param name of the marker
 */
@MessageType("visualization_msgs/InteractiveMarkerPose")
public record InteractiveMarkerPose(Header header, Pose pose, String name) {}
