package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ParameterTest {

  private Graph graph;
  private Parameters parameters;
  private RosNode other;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    parameters = graph
        .open(RosEnvironment.of(Map.of("ROS_MASTER_URI", graph.master().uri().toString()), List.of("__ns:=/robot")),
            "node", graph.options())
        .parameters();
    other = graph.node("other");
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private static XmlRpcValue struct(String name, XmlRpcValue value) {
    return new XmlRpcValue.Struct(Map.of(name, value));
  }

  @Test
  void allTypesComeBackAsTheyWereSet() {
    XmlRpcValue all = new XmlRpcValue.Struct(Map.of("text", XmlRpcValue.of("a<b&c"), "int", XmlRpcValue.of(-5),
        "real", XmlRpcValue.of(0.1), "no", XmlRpcValue.of(false), "list",
        XmlRpcValue.of(XmlRpcValue.of(1), XmlRpcValue.of("x")),
        "bytes", new XmlRpcValue.Binary(new byte[]{0, -1, 7})));
    assertEquals(new Outcome.Done<>(true), parameters.set("all", all));
    assertEquals(new Outcome.Done<>(all), parameters.get("/robot/all"));
    assertEquals(new Outcome.Done<>(XmlRpcValue.of(0.1)), parameters.get("all/real"));
  }

  @Test
  void namesAreRelativeGlobalAndPrivate() {
    parameters.set("a", XmlRpcValue.of(1));
    parameters.set("/b", XmlRpcValue.of(2));
    parameters.set("~c", XmlRpcValue.of(3));
    assertTrue(parameters.names().toOptional().orElseThrow().containsAll(List.of("/robot/a", "/b", "/robot/node/c")));
  }

  @Test
  void deletedParametersAreNotSet() {
    parameters.set("a", XmlRpcValue.of(1));
    assertEquals(new Outcome.Done<>(true), parameters.has("a"));
    assertEquals(new Outcome.Done<>(true), parameters.delete("a"));
    assertEquals(new Outcome.Done<>(false), parameters.has("a"));
    assertInstanceOf(Outcome.Refused.class, parameters.get("a"));
    assertInstanceOf(Outcome.Refused.class, parameters.delete("a"));
  }

  @Test
  void searchFindsTheNearest() {
    parameters.set("/speed", XmlRpcValue.of(1));
    assertEquals(new Outcome.Done<>("/speed"), parameters.search("speed"));
    parameters.set("/robot/speed", XmlRpcValue.of(2));
    assertEquals(new Outcome.Done<>("/robot/speed"), parameters.search("speed"));
    assertInstanceOf(Outcome.Refused.class, parameters.search("height"));
  }

  @Test
  void listenersHearChangesInAndAroundTheirParameter() {
    List<Map.Entry<String, Optional<XmlRpcValue>>> heard = new CopyOnWriteArrayList<>();
    parameters.subscribe("/limits/speed", (key, value) -> heard.add(Map.entry(key.text(), value)));
    Eventually.await("the present value", () -> heard.equals(List.of(Map.entry("/limits/speed", Optional.empty()))));
    other.parameters().set("/limits/speed", XmlRpcValue.of(1));
    Eventually.await("a value", () -> heard.contains(Map.entry("/limits/speed", Optional.of(XmlRpcValue.of(1)))));
    other.parameters().set("/limits", struct("speed", XmlRpcValue.of(2)));
    Eventually.await("a value set by its namespace",
        () -> heard.contains(Map.entry("/limits/speed", Optional.of(XmlRpcValue.of(2)))));
    other.parameters().set("/limits/speed", struct("max", XmlRpcValue.of(3)));
    other.parameters().set("/limits/speed/max", XmlRpcValue.of(4));
    Eventually.await("a value below",
        () -> heard.contains(Map.entry("/limits/speed/max", Optional.of(XmlRpcValue.of(4)))));
    int before = heard.size();
    other.parameters().delete("/limits");
    Eventually.await("the deletion", () -> heard.size() > before
        && heard.get(heard.size() - 1).equals(Map.entry("/limits/speed", Optional.empty())));
    parameters.set("/limits", struct("speed", XmlRpcValue.of(5)));
    Eventually.await("one's own change",
        () -> heard.contains(Map.entry("/limits/speed", Optional.of(XmlRpcValue.of(5)))));
  }

  @Test
  void privateParametersOfTheCommandLineAreSet() throws Exception {
    graph.open(RosEnvironment.of(Map.of("ROS_MASTER_URI", graph.master().uri().toString()), List.of("_rate:=2.5")),
        "cam", graph.options());
    Eventually.await("the parameter",
        () -> parameters.get("/cam/rate").equals(new Outcome.Done<>(XmlRpcValue.of(2.5))));
  }
}
