package org.robotui.ros.internal.node;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.robotui.ros.GraphName;
import org.robotui.ros.InvalidNameException;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.XmlRpcValue.Array;
import org.robotui.ros.XmlRpcValue.Text;
import org.robotui.ros.internal.xmlrpc.ApiMethods;
import org.robotui.ros.internal.xmlrpc.ApiMethods.Arguments;

/** The API through which the master and other nodes talk to this node. */
final class SlaveApi {

  private final NodeParts parts;
  private final NodeParameters parameters;
  private final XmlRpcValue masterUri;
  private final Consumer<String> shutdown;
  private final XmlRpcValue endpoint;
  private final Bus bus;

  SlaveApi(NodeParts parts, NodeParameters parameters, String masterUri, XmlRpcValue endpoint,
      Consumer<String> shutdown) {
    this.parts = parts;
    this.parameters = parameters;
    this.masterUri = XmlRpcValue.of(masterUri);
    this.endpoint = endpoint;
    bus = new Bus(parts);
    this.shutdown = shutdown;
  }

  ApiMethods methods() {
    return new ApiMethods()
        .add("getBusStats", call -> ApiMethods.success("bus stats", bus.stats()))
        .add("getBusInfo", call -> ApiMethods.success("bus info", bus.info()))
        .add("getMasterUri", call -> ApiMethods.success("", masterUri))
        .add("getPid", call -> ApiMethods.success("", (int) ProcessHandle.current().pid()))
        .add("getSubscriptions", call -> ApiMethods.success("subscriptions", subscriptions()))
        .add("getPublications", call -> ApiMethods.success("publications", publications()))
        .add("shutdown", this::shutdown)
        .add("shutdown", this::shutdown, Text.class)
        .add("publisherUpdate", this::publisherUpdate, Text.class, Array.class)
        .add("paramUpdate", this::paramUpdate, Text.class, XmlRpcValue.class)
        .add("requestTopic", this::requestTopic, Text.class, Array.class);
  }

  private XmlRpcValue shutdown(Arguments call) {
    String reason = call.values().size() > 1 ? call.text(1) : "";
    shutdown.accept("shut down by " + call.caller() + ": " + reason);
    return ApiMethods.success("shutdown", 0);
  }

  private XmlRpcValue publisherUpdate(Arguments call) {
    parts.publisherUpdate(call.text(1), GraphCodec.texts(call.value(2)));
    return ApiMethods.success("", 0);
  }

  private XmlRpcValue paramUpdate(Arguments call) {
    try {
      parameters.updated(GraphName.of(call.text(1)), call.value(2));
      return ApiMethods.success("", 0);
    } catch (InvalidNameException e) {
      return ApiMethods.error(e.getMessage(), XmlRpcValue.of(0));
    }
  }

  private XmlRpcValue requestTopic(Arguments call) {
    boolean tcp = call.list(2).stream().map(GraphCodec::list)
        .anyMatch(protocol -> !protocol.isEmpty() && protocol.get(0).equals(XmlRpcValue.of("TCPROS")));
    if (parts.publication(call.text(1)).isEmpty()) {
      return ApiMethods.error("this node does not publish " + call.text(1), XmlRpcValue.of(0));
    }
    return tcp ? ApiMethods.success("ready on TCPROS", endpoint)
        : ApiMethods.error("this node speaks TCPROS only", XmlRpcValue.of(0));
  }

  private XmlRpcValue publications() {
    List<XmlRpcValue> all = new ArrayList<>();
    parts.publications().forEach(p -> all.add(XmlRpcValue.ofTexts(List.of(p.topic().text(), p.info().type()))));
    return new Array(all);
  }

  private XmlRpcValue subscriptions() {
    List<XmlRpcValue> all = new ArrayList<>();
    parts.subscriptions()
        .forEach(s -> all.add(XmlRpcValue.ofTexts(List.of(s.topic().text(), s.codec().info().type()))));
    return new Array(all);
  }
}
