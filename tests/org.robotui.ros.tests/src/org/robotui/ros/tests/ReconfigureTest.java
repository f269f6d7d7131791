package org.robotui.ros.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;
import org.robotui.ros.reconfigure.ConfigChoice;
import org.robotui.ros.reconfigure.ConfigGroup;
import org.robotui.ros.reconfigure.ConfigKind;
import org.robotui.ros.reconfigure.ConfigParameter;
import org.robotui.ros.reconfigure.ConfigValue;
import org.robotui.ros.reconfigure.ConfigValues;
import org.robotui.ros.reconfigure.ReconfigureClient;
import org.robotui.ros.reconfigure.ReconfigureListener;
import org.robotui.ros.reconfigure.ReconfigureServers;

/** Our client with dynamic_reconfigure's own server and its own test configuration. */
class ReconfigureTest {

  private static final Duration TIME = Duration.ofSeconds(10);

  private RosWorld world;
  private RosNode node;
  private Peer server;
  private ReconfigureClient client;

  @BeforeEach
  void start() throws Exception {
    RosInstallation.assumeThere();
    RosInstallation.assumePython("dynamic_reconfigure.cfg.TestConfig", "python3-dynamic-reconfigure");
    world = new RosWorld();
    world.roscore();
    server = world.python("reconfigure_server.py", "tunable");
    node = world.node("client");
    client = ReconfigureClient.open(node, GraphName.of("/tunable"), ReconfigureListener.none());
    assertTrue(client.await(TIME));
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      client.close();
      world.close();
    }
  }

  private ConfigParameter parameter(String name) {
    return client.description().orElseThrow().parameter(name).orElseThrow();
  }

  @Test
  void theServerIsListedAndDescribed() {
    assertEquals(new Outcome.Done<>(List.of("/tunable")), ReconfigureServers.list(node.master()));
    ConfigParameter size = parameter("int_enum_");
    assertEquals("An enum to set the size.", size.choicesDescription());
    assertEquals(List.of("Small", "Medium", "Large", "ExtraLarge"),
        size.choices().stream().map(ConfigChoice::name).toList());
    assertEquals(new ConfigChoice("Large", new ConfigValue.Whole(2), "A large value"), size.choices().get(2));
    assertEquals(Optional.of(new ConfigValue.Real(-2.0)), parameter("double_").min());
    assertEquals(Optional.empty(), parameter("double_no_minmax").max());
    assertEquals(ConfigKind.FLAG, parameter("bool_").kind());
    assertEquals(ConfigKind.TEXT, parameter("str_").kind());
    ConfigGroup inner = client.description().orElseThrow().groups().stream()
        .filter(group -> group.name().equals("GROUP2")).findFirst().orElseThrow();
    assertEquals("collapse", inner.type());
    assertEquals(List.of("group2_double", "group2_string"),
        inner.parameters().stream().map(ConfigParameter::name).limit(2).toList());
  }

  @Test
  void parametersOfEachKindAreSetAndOthersStay() {
    Outcome<ConfigValues> outcome =
        client.set(Map.of("int_", 4, "int_enum_", 2, "str_", "grüße", "bool_", true, "double_", 2.5), TIME);
    Map<String, ConfigValue> values =
        outcome.toOptional().orElseThrow(() -> new AssertionError(outcome.reason())).values();
    assertEquals(new ConfigValue.Text("grüße"), values.get("str_"));
    assertEquals(new ConfigValue.Text("test string"), values.get("group2_string"));
    server.awaitLine("changed 4 2 'grüße' True 2.5");
    Eventually.await("the update",
        () -> client.values().orElseThrow().values().get("int_").equals(new ConfigValue.Whole(4)));
  }

  @Test
  void theServerKeepsNumbersWithinTheirLimits() {
    Outcome<ConfigValues> outcome = client.set(Map.of("int_", 400), TIME);
    assertEquals(new ConfigValue.Whole(10), outcome.toOptional().orElseThrow().values().get("int_"));
  }

  @Test
  void changesOfOthersAreHeard() throws Exception {
    server.tell("int_ -3");
    Eventually.await("the update",
        () -> client.values().orElseThrow().values().get("int_").equals(new ConfigValue.Whole(-3)));
  }
}
