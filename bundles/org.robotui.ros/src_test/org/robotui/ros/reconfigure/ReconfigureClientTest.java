package org.robotui.ros.reconfigure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.net.call.Outcome;
import org.robotui.ros.Eventually;
import org.robotui.ros.Graph;
import org.robotui.ros.GraphName;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.msgs.StandardServices;
import org.robotui.ros.msgs.dynamic_reconfigure.BoolParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.DoubleParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Group;
import org.robotui.ros.msgs.dynamic_reconfigure.GroupState;
import org.robotui.ros.msgs.dynamic_reconfigure.IntParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.ParamDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureResponse;
import org.robotui.ros.msgs.dynamic_reconfigure.StrParameter;

/** The client at a server that says whatever a test wants. */
class ReconfigureClientTest {

  private static final Duration TIME = Duration.ofSeconds(30);
  private static final Config NONE = new Config(List.of(), List.of(), List.of(), List.of(), List.of());

  private final List<Config> asked = new CopyOnWriteArrayList<>();
  private Graph graph;
  private RosNode node;
  private Publisher<ConfigDescription> descriptions;
  private Publisher<Config> updates;
  private ReconfigureClient client;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    RosNode server = graph.node("server");
    descriptions = server.publisher("~parameter_descriptions", RecordCodec.of(ConfigDescription.class),
        PublisherOptions.latched());
    updates = server.publisher("~parameter_updates", RecordCodec.of(Config.class), PublisherOptions.latched());
    server.serviceServer("~set_parameters", StandardServices.RECONFIGURE, (request, caller) -> {
      asked.add(request.config());
      return new ReconfigureResponse(config(9, true));
    });
    node = graph.node("client");
    client = ReconfigureClient.open(node, GraphName.of("/server"), ReconfigureListener.none());
  }

  @AfterEach
  void stop() {
    client.close();
    graph.close();
  }

  private static Config config(int rate, boolean open) {
    return new Config(List.of(new BoolParameter("on", true)), List.of(new IntParameter("rate", rate)),
        List.of(new StrParameter("frame", "map")),
        List.of(new DoubleParameter("gain", 0.5)), List.of(new GroupState("Default", open, 0, 0)));
  }

  private static ParamDescription parameter(String name, String type, String method) {
    return new ParamDescription(name, type, 4, "about " + name, method);
  }

  private void describe() {
    Group inner = new Group("Inner", "collapse", List.of(parameter("gain", "double", ""), parameter("frame", "str", ""),
        parameter("strange", "matrix", "")), 0, 1);
    Group outer = new Group("Default", "", List.of(parameter("on", "bool", ""), parameter("rate", "int",
        "{'enum': [{'name': 'Slow', 'value': 1, 'description': ''}], 'enum_description': 'how often'}")), 0, 0);
    Config max = new Config(List.of(), List.of(new IntParameter("rate", 10)), List.of(),
        List.of(new DoubleParameter("gain", Double.POSITIVE_INFINITY)), List.of());
    descriptions.publish(new ConfigDescription(List.of(outer, inner), max, NONE, config(3, true)));
    updates.publish(config(3, true));
    assertTrue(client.await(TIME));
  }

  @Test
  void theServerIsFound() {
    Eventually.await("the server",
        () -> ReconfigureServers.list(node.master()).equals(new Outcome.Done<>(List.of("/server"))));
  }

  @Test
  void theDescriptionIsReadInItsGroups() {
    describe();
    ServerDescription description = client.description().orElseThrow();
    assertEquals(List.of("on", "rate", "gain", "frame"),
        description.parameters().stream().map(ConfigParameter::name).toList());
    assertEquals(
        new ConfigParameter("rate", ConfigKind.WHOLE, "about rate", 4, Optional.empty(),
            Optional.of(new ConfigValue.Whole(10)),
            Optional.of(new ConfigValue.Whole(3)), List.of(new ConfigChoice("Slow", new ConfigValue.Whole(1), "")),
            "how often"),
        description.parameter("rate").orElseThrow());
    assertEquals(Optional.empty(), description.parameter("gain").orElseThrow().max());
    assertEquals(1, description.groups().get(1).id());
    assertEquals(Map.of(0, true), client.values().orElseThrow().groups());
  }

  @Test
  void changesAreSentAloneAndAnsweredInFull() {
    describe();
    Outcome<ConfigValues> outcome = client.set(Map.of("rate", "9"), TIME);
    assertEquals(new ConfigValue.Whole(9), outcome.toOptional().orElseThrow().values().get("rate"));
    assertEquals(new Config(List.of(), List.of(new IntParameter("rate", 9)), List.of(), List.of(), List.of()),
        asked.get(0));
  }

  @Test
  void whatDoesNotFitIsNotSent() {
    assertInstanceOf(Outcome.Refused.class, client.set(Map.of("rate", 1), TIME));
    describe();
    for (Map<String, ?> wrong : List.of(Map.of("rate", 1.5), Map.of("rate", 1L << 40), Map.of("on", "maybe"),
        Map.of("gain", "much"), Map.of("rat", 1))) {
      Outcome<ConfigValues> outcome = client.set(wrong, TIME);
      assertInstanceOf(Outcome.Refused.class, outcome);
      assertTrue(outcome.reason().contains(wrong.keySet().iterator().next()), outcome.reason());
    }
    assertEquals(List.of(), asked);
  }

  @Test
  void updatesOfOthersAreHeard() {
    describe();
    updates.publish(config(5, false));
    Eventually.await("the update",
        () -> client.values().orElseThrow().values().get("rate").equals(new ConfigValue.Whole(5)));
    assertEquals(Map.of(0, false), client.values().orElseThrow().groups());
  }

  @Test
  void endlessDescriptionsAreIgnored() {
    Group endless =
        new Group("Default", "", Collections.nCopies(Configs.MAX_PARAMETERS, parameter("a", "int", "")), 0, 0);
    descriptions.publish(new ConfigDescription(List.of(endless), NONE, NONE, NONE));
    updates.publish(config(1, true));
    Eventually.await("the values", () -> client.values().isPresent());
    assertEquals(Optional.empty(), client.description());
    describe();
  }
}
