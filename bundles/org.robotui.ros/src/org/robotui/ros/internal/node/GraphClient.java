package org.robotui.ros.internal.node;

import java.io.IOException;
import java.util.List;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.GraphName;
import org.robotui.ros.MasterGraph;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;
import org.robotui.ros.XmlRpcValue;

/** Asks the master about the graph. */
record GraphClient(NodeContext context, RosApi master, CloseableSet sockets) implements MasterGraph {

  @Override
  public Outcome<List<TopicInfo>> publishedTopics() {
    return call("getPublishedTopics", "").map(GraphCodec::topics);
  }

  @Override
  public Outcome<List<TopicInfo>> topicTypes() {
    return call("getTopicTypes").map(GraphCodec::topics);
  }

  @Override
  public Outcome<SystemState> systemState() {
    return call("getSystemState").map(GraphCodec::state);
  }

  @Override
  public Outcome<String> lookupNode(String node) {
    return call("lookupNode", GraphName.of(node).text()).map(GraphClient::text);
  }

  @Override
  public Outcome<String> lookupService(String service) {
    return call("lookupService", GraphName.of(service).text()).map(GraphClient::text);
  }

  @Override
  public Outcome<Integer> ping(String node) {
    Outcome<String> uri = lookupNode(node);
    return uri instanceof Outcome.Done<String> done ? pid(node, done.value()) : uri.map(never -> 0);
  }

  private Outcome<Integer> pid(String node, String uri) {
    try (RosApi slave = new RosApi(HostPort.ofUri(uri, "http"), "node " + node, context.handshake())) {
      if (!sockets.add(slave)) {
        throw new IOException("closed");
      }
      return slave.call("getPid", XmlRpcValue.of(context.name().text()))
          .map(pid -> pid instanceof XmlRpcValue.Int number ? number.value() : 0);
    } catch (IllegalArgumentException | IOException e) {
      return new Outcome.Failed<>("node " + node + ": " + e.getMessage());
    }
  }

  private static String text(XmlRpcValue value) {
    return value instanceof XmlRpcValue.Text text ? text.value() : "";
  }

  private Outcome<XmlRpcValue> call(String method, String... arguments) {
    XmlRpcValue[] all = new XmlRpcValue[arguments.length + 1];
    all[0] = XmlRpcValue.of(context.name().text());
    for (int i = 0; i < arguments.length; i++) {
      all[i + 1] = XmlRpcValue.of(arguments[i]);
    }
    return master.call(method, all);
  }
}
