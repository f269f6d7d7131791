/**
 * Topics that carry messages, as the ports of a robot: what robot interfaces share whose frameworks have them. A
 * framework gives a {@link org.robotui.message.topic.TopicClient}, and says from time to time who publishes and
 * subscribes what; {@link org.robotui.message.topic.RobotTopics} makes streams and commands of it.
 */
@org.osgi.annotation.versioning.Version("2.4.0")
package org.robotui.message.topic;
