package org.robotui.ros.action;

import org.robotui.ros.GraphName;

/**
 * An action somebody serves.
 *
 * @param name the action's name, such as {@code /move_base}
 * @param type the name of its type, such as {@code move_base_msgs/MoveBaseAction}; {@code *} if the master does not
 * know
 * @param server the server's node name
 */
public record ActionInfo(GraphName name, String type, String server) {}
