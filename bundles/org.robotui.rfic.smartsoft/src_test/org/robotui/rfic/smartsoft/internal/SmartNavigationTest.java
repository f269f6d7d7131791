package org.robotui.rfic.smartsoft.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.Rfic;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.geometry.RigidTransform;
import org.robotui.guard.Guards;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.smartsoft.internal.feed.SmartCommanding;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.client.ParameterMaster.Response;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.naming.NamingService;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.server.ParameterSlave;
import org.robotui.smartsoft.server.PushServer;
import org.robotui.smartsoft.server.QueryServer;
import org.robotui.smartsoft.server.SendServer;
import org.robotui.smartsoft.server.SmartComponent;
import org.robotui.smartsoft.server.SmartServerOptions;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.rfic.Peer;

/** A mapper and a planner of our own, written after the published models of SmartSoft's repositories. */
@Timeout(120)
class SmartNavigationTest {
  private static final String REQUEST = "CommNavigationObjects::CommGridMapRequest";
  private static final String MAP = "CommNavigationObjects::CommGridMap";
  private static final String GOAL = "CommNavigationObjects::CommPlannerGoal";
  private static final FrameId FRAME = new FrameId("robby", "map");

  private final CommTypes types = CommTypes.shipped();
  private final FakeRficContext context = new FakeRficContext();
  private final SmartServerOptions options = SmartServerOptions.loopback(Peer.THREADS);
  private final List<String> told = new CopyOnWriteArrayList<>();
  private volatile Response response = Response.OK;
  private NamingService naming;
  private SmartComponent mapper;
  private SmartComponent planner;
  private Rfic rfic;

  @BeforeEach
  void open() throws IOException {
    naming = new NamingService(Peer.THREADS, InetAddress.getLoopbackAddress(), 0);
    mapper = component("mapper");
    mapper.offer(SmartPattern.QUERY, "curMap", List.of(REQUEST, MAP), new QueryServer(options, asked -> {
      told.add("map of " + types.get(REQUEST).read(asked).number("xSizeMM").orElseThrow());
      return types.get(MAP).bytes(Map.of("xOffsetMM", -1000, "yOffsetMM", 500, "cellSizeMM", 100, "xSizeCells", 2,
          "ySizeCells", 2, "size", 4, "cell", List.of(0, 127, 205, 254)));
    }));
    planner = component("planner");
    planner.offer(SmartPattern.PUSH, "plannerGoal", List.of(GOAL), new PushServer(options, Duration.ZERO));
    planner.offer(SmartPattern.QUERY, "param", List.of(ParameterMaster.REQUEST, ParameterMaster.RESPONSE),
        new QueryServer(options, new ParameterSlave(types, (name, values) -> {
          told.add(name + " " + values);
          return response;
        })));
    planner.offer(SmartPattern.SEND, "drive", List.of(SmartCommanding.VELOCITY),
        new SendServer(options, object -> told.add("velocity")));
    rfic = SmartSessions.rfic(context,
        SmartPeer.settings(Map.of("host", "127.0.0.1", "port", (long) naming.port())), new Guards());
    rfic.start();
  }

  private SmartComponent component(String name) throws IOException {
    return new SmartComponent(name, NamingClient.connect(new HostPort("127.0.0.1", naming.port()),
        SocketFactory.getDefault(), Duration.ofSeconds(20)));
  }

  @AfterEach
  void close() {
    rfic.close();
    mapper.close();
    planner.close();
    naming.close();
  }

  private void await(String what, Callable<Boolean> condition) throws Exception {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.call()) {
      assertTrue(System.nanoTime() < end, () -> what + " " + told);
      Thread.sleep(20);
    }
  }

  @SuppressWarnings("unchecked")
  private <D extends Data> CommandSink<D> sink(String port) throws Exception {
    await(port, () -> context.sinks.containsKey(port));
    return (CommandSink<D>) context.sinks.get(port);
  }

  @Test
  void a_map_is_asked_for_while_somebody_looks() throws Exception {
    await("it is offered", () -> context.streams.containsKey("mapper/curMap"));
    assertEquals(List.of(), told);
    context.demand("mapper/curMap", true);
    await("a map", () -> !context.published.get("mapper/curMap").isEmpty());
    GridMap map = (GridMap) context.published.get("mapper/curMap").getLast().value();
    assertEquals(List.of(0, 100, -1, 100), List.of((int) map.cell(0, 0), (int) map.cell(1, 0), (int) map.cell(0, 1),
        (int) map.cell(1, 1)));
    assertEquals(RigidTransform.planar(-1, 0.5, 0), map.origin());
    assertEquals("map of 60000.0", told.getFirst());
  }

  @Test
  void goals_are_told_and_deleted_with_a_stop() throws Exception {
    CommandSink<NavigationGoal> goals = sink("planner/goal");
    CommandSink<VelocityCommand> base = sink("velocity");
    base.stop(VelocityCommand.ZERO, false);
    NavigationGoal goal = new NavigationGoal(FRAME, RigidTransform.planar(1.2345, -2, 0.5));
    assertEquals(new Sent.Out(), goals.send(goal));
    await("it is told",
        () -> told.contains("CommNavigationObjects.PlannerParams.SETDESTINATIONCIRCLE [1235, -2000, 100]"));
    base.stop(VelocityCommand.ZERO, false);
    await("it is deleted", () -> told.contains("CommNavigationObjects.PlannerParams.DELETEGOAL []"));
    base.stop(VelocityCommand.ZERO, false);
    response = Response.INVALID;
    await("a refusal is told", () -> goals.send(goal) instanceof Sent.Refused refused
        && refused.reason().contains("does not know SETDESTINATIONCIRCLE"));
    assertEquals(1, told.stream().filter(each -> each.contains("DELETEGOAL")).count());
    assertInstanceOf(Sent.Refused.class, goals.send(new NavigationGoal(new FrameId("robby", "odom"), goal.pose())));
  }
}
