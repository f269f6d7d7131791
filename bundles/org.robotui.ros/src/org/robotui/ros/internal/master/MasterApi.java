package org.robotui.ros.internal.master;

import java.util.Optional;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.XmlRpcValue.Text;
import org.robotui.ros.internal.xmlrpc.ApiMethods;
import org.robotui.ros.internal.xmlrpc.ApiMethods.Arguments;

/** The master's API: registration and look-up. */
final class MasterApi {

  private final Registry registry;
  private final String uri;

  MasterApi(Registry registry, String uri) {
    this.registry = registry;
    this.uri = uri;
  }

  void addTo(ApiMethods methods) {
    methods.add("registerService", this::registerService, Text.class, Text.class, Text.class)
        .add("unregisterService", this::unregisterService, Text.class, Text.class)
        .add("registerSubscriber", this::registerSubscriber, Text.class, Text.class, Text.class)
        .add("unregisterSubscriber", this::unregisterSubscriber, Text.class, Text.class)
        .add("registerPublisher", this::registerPublisher, Text.class, Text.class, Text.class)
        .add("unregisterPublisher", this::unregisterPublisher, Text.class, Text.class)
        .add("lookupNode", this::lookupNode, Text.class)
        .add("lookupService", this::lookupService, Text.class)
        .add("getPublishedTopics", this::published, Text.class)
        .add("getTopicTypes", call -> ApiMethods.success("current system state", registry.types()))
        .add("getSystemState", call -> ApiMethods.success("current system state", registry.state()))
        .add("getUri", call -> ApiMethods.success("", XmlRpcValue.of(uri)))
        .add("getMasterUri", call -> ApiMethods.success("", XmlRpcValue.of(uri)))
        .add("getPid", call -> ApiMethods.success("", (int) ProcessHandle.current().pid()));
  }

  private static String name(Arguments call) {
    return MasterNames.resolve(call.caller(), call.text(1));
  }

  private static String caller(Arguments call) {
    return MasterNames.resolve("/", call.caller());
  }

  private XmlRpcValue registerService(Arguments call) {
    registry.addService(caller(call), call.text(3), name(call), call.text(2));
    return ApiMethods.success("Registered [" + call.caller() + "] as provider of [" + name(call) + "]", 1);
  }

  private XmlRpcValue unregisterService(Arguments call) {
    return removed(call, registry.removeService(caller(call), name(call), call.text(2)), "provider");
  }

  private XmlRpcValue registerSubscriber(Arguments call) {
    XmlRpcValue publishers = XmlRpcValue.ofTexts(
        registry.addSubscriber(caller(call), call.text(3), name(call), call.text(2)));
    return ApiMethods.success("Subscribed to [" + name(call) + "]", publishers);
  }

  private XmlRpcValue unregisterSubscriber(Arguments call) {
    return removed(call, registry.removeSubscriber(caller(call), call.text(2), name(call)), "subscriber");
  }

  private XmlRpcValue registerPublisher(Arguments call) {
    XmlRpcValue subscribers = XmlRpcValue.ofTexts(
        registry.addPublisher(caller(call), call.text(3), name(call), call.text(2)));
    return ApiMethods.success("Registered [" + call.caller() + "] as publisher of [" + name(call) + "]", subscribers);
  }

  private XmlRpcValue unregisterPublisher(Arguments call) {
    return removed(call, registry.removePublisher(caller(call), call.text(2), name(call)), "publisher");
  }

  private static XmlRpcValue removed(Arguments call, boolean removed, String role) {
    return removed
        ? ApiMethods.success("Unregistered [" + call.caller() + "] as " + role + " of [" + name(call) + "]", 1)
        : ApiMethods.success("[" + call.caller() + "] is not a registered " + role + " of [" + name(call) + "]", 0);
  }

  private XmlRpcValue lookupNode(Arguments call) {
    return found(registry.node(name(call)), "node api", "unknown node [" + name(call) + "]");
  }

  private XmlRpcValue lookupService(Arguments call) {
    return found(registry.service(name(call)), "rosrpc URI", "no provider of [" + name(call) + "]");
  }

  private static XmlRpcValue found(Optional<String> uri, String status, String problem) {
    return uri.map(there -> ApiMethods.success(status, XmlRpcValue.of(there)))
        .orElseGet(() -> ApiMethods.error(problem, XmlRpcValue.of("")));
  }

  private XmlRpcValue published(Arguments call) {
    String namespace = call.text(1).isEmpty() ? "/" : name(call);
    return ApiMethods.success("current topics", registry.published(namespace));
  }
}
