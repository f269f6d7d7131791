package org.robotui.ros;

import java.util.List;
import org.robotui.net.call.Outcome;

/** The graph of nodes, topics and services as the master knows it. Calls wait for the master. */
public interface MasterGraph {

  /**
   * The topics that have a publisher.
   *
   * @return topics with their types
   */
  Outcome<List<TopicInfo>> publishedTopics();

  /**
   * The types of all topics the master ever heard of.
   *
   * @return topics with their types
   */
  Outcome<List<TopicInfo>> topicTypes();

  /**
   * Who publishes, subscribes and serves what.
   *
   * @return the state
   */
  Outcome<SystemState> systemState();

  /**
   * The address of a node's own API.
   *
   * @param node the node's global name
   * @return a URI; refused if there is no such node
   */
  Outcome<String> lookupNode(String node);

  /**
   * The address of a service.
   *
   * @param service the service's global name
   * @return a {@code rosrpc} URI; refused if there is no such service
   */
  Outcome<String> lookupService(String service);

  /**
   * Asks a node itself whether it is alive.
   *
   * @param node the node's global name
   * @return its process id
   */
  Outcome<Integer> ping(String node);
}
