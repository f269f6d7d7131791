package org.robotui.ros;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;

/** A master and nodes of one test; closing it checks that nothing is left. */
public final class Graph implements AutoCloseable {

  private final TestThreads threads = new TestThreads();
  private final List<RosNode> nodes = new ArrayList<>();
  private RosMaster master;

  public Graph() throws IOException {
    master = RosMaster.open(MasterOptions.standard(threads));
  }

  public RosMaster master() {
    return master;
  }

  public TestThreads threads() {
    return threads;
  }

  /** Ends the master and starts a new one at the same address. */
  public void restartMaster() throws IOException {
    int port = master.uri().getPort();
    master.close();
    master = RosMaster.open(MasterOptions.standard(threads).withPort(port));
  }

  /** The options of quick tests. */
  public NodeOptions options() {
    return NodeOptions.standard(threads).withTimes(Duration.ofSeconds(2), Duration.ofMillis(200),
        Duration.ofMillis(500));
  }

  public RosNode node(String name) throws IOException {
    return node(name, LinkListener.none());
  }

  public RosNode node(String name, LinkListener links) throws IOException {
    return open(RosEnvironment.of(master.uri()), name, options().withLinks(links));
  }

  public RosNode open(RosEnvironment environment, String name, NodeOptions options) throws IOException {
    RosNode node = RosNode.open(environment, GraphName.of(name), options);
    nodes.add(node);
    return node;
  }

  @Override
  public void close() {
    nodes.forEach(RosNode::close);
    master.close();
    threads.assertNoneLeft();
  }
}
