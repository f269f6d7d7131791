package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * An outline with time and frame ({@code geometry_msgs/PolygonStamped}).
 *
 * @param header time and frame
 * @param polygon the outline
 */
@MessageType("geometry_msgs/PolygonStamped")
public record PolygonStamped(Header header, Polygon polygon) {}
