package org.robotui.message.topic.internal;

/**
 * What is offered because others publish it. The robot is only asked for it while somebody wants it. For the thread
 * that follows the graph.
 */
interface Followed extends AutoCloseable {
  String topic();

  String type();

  boolean wanted();

  /** Whether messages can come: a publisher is connected. */
  boolean flowing();

  /** Subscribes or unsubscribes as is wanted now. */
  void applyDemand();

  /** Whether somebody publishes the topic now; reports what is missing to whom it may concern. */
  void published(boolean now);

  /** What is wanted but does not come, empty where all is well. */
  String problem();

  @Override
  void close();
}
