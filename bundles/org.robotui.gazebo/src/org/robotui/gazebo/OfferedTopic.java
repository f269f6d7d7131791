package org.robotui.gazebo;

/**
 * A topic that a node of another process publishes, or subscribes to.
 *
 * @param name of the topic
 * @param type the full name of the type of its messages, such as {@code ignition.msgs.Twist}
 * @param address where messages are published, such as {@code tcp://127.0.0.1:40001}
 * @param process which process it is in
 * @param node which node of the process
 */
public record OfferedTopic(QualifiedName name, String type, String address, String process, String node) {}
