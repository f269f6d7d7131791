package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.message.DynamicMessage;
import org.robotui.message.RosValue;
import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.client.PushClient;
import org.robotui.smartsoft.client.QueryClient;
import org.robotui.smartsoft.client.SendClient;
import org.robotui.smartsoft.client.PatternClient;
import org.robotui.smartsoft.client.StateMaster;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.LinkOptions;

/** The simulated robots as components of SmartSoft, seen by clients of ours. */
@Timeout(120)
class DemoSmartTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();

  private final CommTypes types = CommTypes.shipped();
  private final LinkOptions links = LinkOptions.of(THREADS);
  private final List<PatternClient> clients = new ArrayList<>();
  private Demo demo;

  @AfterEach
  void end() {
    clients.forEach(PatternClient::close);
    demo.close();
  }

  private NamedService service(String path) throws IOException {
    String at = demo.addresses().get("SMART_NS_ADDR");
    int colon = at.indexOf(':');
    HostPort naming = new HostPort(at.substring(0, colon), Integer.parseInt(at.substring(colon + 1)));
    try (NamingClient client = NamingClient.connect(naming, SocketFactory.getDefault(), PATIENCE)) {
      return client.list().stream().filter(each -> each.name().path().equals(path)).findFirst().orElseThrow();
    }
  }

  private DynamicMessage await(String path, Predicate<DynamicMessage> wanted) throws Exception {
    NamedService service = service(path);
    CommType type = types.get(service.name().types().getFirst());
    BlockingQueue<ByteBuffer> updates = new LinkedBlockingQueue<>();
    try (PushClient client = PushClient.connect(service.address(), links, updates::add)) {
      client.subscribe(1);
      long end = System.nanoTime() + PATIENCE.toNanos();
      while (true) {
        ByteBuffer update = updates.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
        assertNotNull(update, "no such " + path);
        DynamicMessage read = type.read(update);
        if (wanted.test(read)) {
          return read;
        }
      }
    }
  }

  private QueryClient query(String path) throws IOException {
    QueryClient client = QueryClient.connect(service(path).address(), links);
    clients.add(client);
    return client;
  }

  private static double number(DynamicMessage object, String path) {
    return object.number(path).orElseThrow();
  }

  @Test
  void natalieTellsWhatSheMeasuresAndIsDriven() throws Exception {
    demo = Demo.start(Options.parse(List.of("--robot", "natalie", "--speak", "smartsoft")));
    DynamicMessage laser = await("laser/laserScan", any -> true);
    assertEquals(27_000, number(laser, "laser_scan_pose.laser_scan.start_angle"), 1e-6);
    assertEquals(361, number(laser, "laser_scan_pose.laser_scan.max_scan_points"));
    assertEquals(120, number(laser, "laser_scan_pose.sensor_pose.position.x"), 1e-6);
    DynamicMessage map = await("mapper/currMap", any -> true);
    assertTrue(map.field("cell").orElseThrow() instanceof RosValue.Numbers cells
        && cells.values().size() == number(map, "xSizeCells") * number(map, "ySizeCells"));
    NamedService drive = service("base/navigationVelocity");
    SendClient sender = SendClient.connect(drive.address(), links);
    clients.add(sender);
    CommType velocity = types.get(drive.name().types().getFirst());
    ByteBuffer forward = velocity.bytes(Map.of("vX", 200));
    await("base/baseState", m -> {
      sender.send(forward.duplicate().order(forward.order())); // again and again, as a robot stops that is told no more
      return number(m, "baseVelocity.vX") > 150;
    });
    sender.send(velocity.bytes(Map.of()));
    await("base/baseState", m -> number(m, "baseVelocity.vX") == 0);
  }

  @Test
  void natalieGoesWhereAParameterSaysUntilHerPlannerIsNeutral() throws Exception {
    demo = Demo.start(Options.parse(List.of("--robot", "natalie", "--speak", "smartsoft")));
    QueryClient states = query("base/baseStateQuery");
    DynamicMessage state = types.get("CommBasicObjects::CommBaseState").read(
        states.query(types.get("CommBasicObjects::CommVoid").bytes(Map.of()), PATIENCE));
    double x = number(state, "basePose.pose3D.position.x");
    double y = number(state, "basePose.pose3D.position.y");
    ParameterMaster parameters = new ParameterMaster(query("planner/param"), types, PATIENCE);
    assertEquals(ParameterMaster.Response.INVALID,
        parameters.send("CommNavigationObjects.PlannerParams.SETDESTINATIONCIRCLE", List.of("here", "there", "0")));
    assertEquals(ParameterMaster.Response.OK, parameters.send(
        "CommNavigationObjects.PlannerParams.SETDESTINATIONCIRCLE", List.of(Double.toString(x + 500),
            Double.toString(y), "100")));
    assertEquals(x + 500, number(await("planner/plannerGoal", any -> true), "xGoalPoint"), 1e-3);
    StateMaster planner = new StateMaster(query("planner/state"), types, PATIENCE);
    planner.change("Neutral");
    assertEquals("Neutral", planner.current());
    await("base/baseState", m -> number(m, "baseVelocity.vX") == 0);
  }
}
