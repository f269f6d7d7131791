package org.robotui.message.ros.move_base_msgs;

import org.robotui.message.MessageType;

/** Ends a drive; says nothing ({@code move_base_msgs/MoveBaseResult}). */
@MessageType("move_base_msgs/MoveBaseResult")
public record MoveBaseResult() {}
