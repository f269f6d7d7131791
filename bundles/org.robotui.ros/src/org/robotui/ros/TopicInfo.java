package org.robotui.ros;

/**
 * A topic as the master knows it.
 *
 * @param name the topic's global name
 * @param type the full name of its message type; {@code *} if nobody said
 */
public record TopicInfo(String name, String type) {}
