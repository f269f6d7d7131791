package org.robotui.sim.internal.smartsoft;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;
import org.robotui.message.MessageException;
import org.robotui.net.socket.HostPort;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.naming.NamingService;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.server.EventServer;
import org.robotui.smartsoft.server.ParameterSlave;
import org.robotui.smartsoft.server.PushServer;
import org.robotui.smartsoft.server.QueryServer;
import org.robotui.smartsoft.server.SendServer;
import org.robotui.smartsoft.server.SmartServerOptions;
import org.robotui.smartsoft.server.PatternServer;
import org.robotui.smartsoft.server.SmartComponent;
import org.robotui.smartsoft.server.StateSlave;

/**
 * The robot as components of SmartSoft: a naming service on loopback, base, laser, mapper, localisation and planner.
 */
public final class SmartFace implements Face {
  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final Rate BASE = new Rate(20);
  private static final Rate MAP = new Rate(0.5);
  private static final Rate PARTICLES = new Rate(1);
  private static final Rate GOAL = new Rate(2);
  private static final Rate BUMPER = new Rate(20);
  private static final String BASIC = "CommBasicObjects::";
  private static final String NAVIGATION = "CommNavigationObjects::";

  private final int port;
  private final ThreadFactory threads;
  private final CommTypes types = CommTypes.shipped();
  private final List<SmartComponent> components = new ArrayList<>();
  private Optional<NamingService> naming = Optional.empty();
  private Optional<Shown> shown = Optional.empty();
  private volatile long now;

  /** What there is once the robot is shown. */
  private record Shown(SimulatedRobot robot, SmartObjects objects, PushServer base, PushServer laser, PushServer map,
      PushServer particles, PushServer goal, EventServer<Boolean> bumper) {}

  /** @param port where the naming service listens; 0 for a free one */
  public SmartFace(int port, ThreadFactory threads) {
    this.port = port;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot robot, long stamp) throws IOException {
    now = stamp;
    naming = Optional.of(new NamingService(threads, InetAddress.getLoopbackAddress(), port));
    SmartObjects objects = new SmartObjects(robot, () -> now);
    SmartTasks tasks = new SmartTasks(robot, types);
    SmartComponent base = component("base");
    SmartComponent planner = component("planner");
    PushServer state = push(base, "baseState", BASIC + "CommBaseState", BASE);
    offer(base, SmartPattern.SEND, "navigationVelocity", List.of(SmartTasks.VELOCITY),
        new SendServer(options(), tasks::drive));
    offer(base, SmartPattern.QUERY, "baseStateQuery", List.of(BASIC + "CommVoid", BASIC + "CommBaseState"),
        new QueryServer(options(), asked -> bytes(BASIC + "CommBaseState", objects.base(robot.state()))));
    EventServer<Boolean> bumper = offer(base, SmartPattern.EVENT, "bumperEvent",
        List.of(BASIC + "CommBumperEventParameter", BASIC + "CommBumperEventResult"),
        new EventServer<>(options(), this::bumped));
    offer(planner, SmartPattern.QUERY, "param", SmartTasks.PARAMETER,
        new QueryServer(options(), new ParameterSlave(types, tasks::parameter)));
    offer(planner, SmartPattern.QUERY, "state", SmartTasks.STATE,
        new QueryServer(options(), new StateSlave(types, SmartTasks.STATES, tasks::state)));
    shown = Optional.of(new Shown(robot, objects, state,
        push(component("laser"), "laserScan", BASIC + "CommMobileLaserScan",
            new Rate(robot.model().laser().frequency())),
        push(component("mapper"), "currMap", NAVIGATION + "CommGridMap", MAP),
        push(component("localization"), "visualization", "CommLocalizationObjects::CommAmclVisualizationInfo",
            PARTICLES),
        push(planner, "plannerGoal", NAVIGATION + "CommPlannerGoal", GOAL), bumper));
  }

  private SmartServerOptions options() {
    return SmartServerOptions.loopback(threads);
  }

  private SmartComponent component(String name) throws IOException {
    HostPort at = new HostPort("127.0.0.1", naming.orElseThrow().port());
    SmartComponent made =
        new SmartComponent(name, NamingClient.connect(at, SocketFactory.getDefault(), PATIENCE));
    components.add(made);
    return made;
  }

  private static <S extends PatternServer> S offer(SmartComponent component, SmartPattern pattern, String service,
      List<String> types, S server) throws IOException {
    return component.offer(pattern, service, types, server);
  }

  private PushServer push(SmartComponent component, String service, String type, Rate rate) throws IOException {
    return offer(component, SmartPattern.PUSH, service, List.of(type),
        new PushServer(options(), Duration.ofMillis(Math.round(1000 / rate.hertz()))));
  }

  /** Tells whoever believes in another state than the one it is in, once for each state. */
  private Optional<EventServer.Happening> bumped(ByteBuffer parameter, Boolean pressed) throws MessageException {
    int state = pressed ? SmartObjects.PRESSED : SmartObjects.NOT_PRESSED;
    CommType asked = types.get(BASIC + "CommBumperEventParameter");
    return asked.read(parameter).number("oldState").orElse(0) == state ? Optional.empty()
        : Optional.of(new EventServer.Happening(bytes(BASIC + "CommBumperEventResult", Map.of("state", state)),
            asked.bytes(Map.of("oldState", state))));
  }

  private ByteBuffer bytes(String type, Map<String, ?> object) throws MessageException {
    return types.get(type).bytes(object);
  }

  /** Made only where somebody has subscribed. */
  private interface Made {
    Map<String, ?> object();
  }

  private void put(PushServer server, String type, Made made) {
    if (server.subscribers() > 0) {
      try {
        server.put(bytes(type, made.object()));
      } catch (MessageException e) {
        throw new IllegalStateException(e);
      }
    }
  }

  @Override
  public void step(long step, long stamp) {
    now = stamp;
    shown.ifPresent(all -> step(all, step, all.robot().state()));
  }

  private void step(Shown all, long step, RobotState state) {
    SmartObjects objects = all.objects();
    if (BASE.isDue(step)) {
      put(all.base(), BASIC + "CommBaseState", () -> objects.base(state));
    }
    if (all.robot().sensors().isScanDue(step)) {
      put(all.laser(), BASIC + "CommMobileLaserScan",
          () -> objects.laser(state, all.robot().sensors().scan(step)));
    }
    if (MAP.isDue(step)) {
      put(all.map(), NAVIGATION + "CommGridMap", objects::map);
    }
    if (PARTICLES.isDue(step)) {
      put(all.particles(), "CommLocalizationObjects::CommAmclVisualizationInfo", () -> objects.particles(state));
    }
    if (GOAL.isDue(step) && state.goal().isPresent()) {
      put(all.goal(), NAVIGATION + "CommPlannerGoal", () -> objects.goal(state));
    }
    if (BUMPER.isDue(step)) {
      all.bumper().put(state.bumped());
    }
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    naming.ifPresent(listening -> variables.put("SMART_NS_ADDR", "127.0.0.1:" + listening.port()));
    return variables;
  }

  @Override
  public void close() {
    components.forEach(SmartComponent::close);
    naming.ifPresent(NamingService::close);
  }
}
