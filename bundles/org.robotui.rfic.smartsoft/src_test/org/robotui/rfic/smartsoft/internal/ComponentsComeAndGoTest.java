package org.robotui.rfic.smartsoft.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.guard.Guards;
import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.naming.NamingService;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.server.PushServer;
import org.robotui.smartsoft.server.QueryServer;
import org.robotui.smartsoft.server.SendServer;
import org.robotui.smartsoft.server.SmartServerOptions;
import org.robotui.smartsoft.server.SmartComponent;
import org.robotui.smartsoft.server.StateSlave;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.rfic.Peer;

/** Naming services and components end and are started again, in any order. */
@Timeout(120)
class ComponentsComeAndGoTest {
  private static final String STATE = "CommBasicObjects::CommBaseState";
  private static final String VELOCITY = "CommBasicObjects::CommNavigationVelocity";

  private final CommTypes types = CommTypes.shipped();
  private final FakeRficContext context = new FakeRficContext();
  private final SmartServerOptions options = SmartServerOptions.loopback(Peer.THREADS);
  private NamingService naming;
  private Rfic rfic;

  @BeforeEach
  void open() throws IOException {
    naming = new NamingService(Peer.THREADS, InetAddress.getLoopbackAddress(), 0);
    rfic = SmartSessions.rfic(context,
        SmartPeer.settings(Map.of("host", "127.0.0.1", "port", (long) naming.port())), new Guards());
    rfic.start();
  }

  @AfterEach
  void close() {
    rfic.close();
    naming.close();
  }

  private final class Base implements AutoCloseable {
    final SmartComponent component;
    final PushServer state;
    final List<Double> heard = new CopyOnWriteArrayList<>();

    Base() throws IOException {
      component = new SmartComponent("base", NamingClient.connect(new HostPort("127.0.0.1", naming.port()),
          SocketFactory.getDefault(), Duration.ofSeconds(20)));
      state = component.offer(SmartPattern.PUSH, "state", List.of(STATE), new PushServer(options, Duration.ZERO));
      component.offer(SmartPattern.SEND, "drive", List.of(VELOCITY),
          new SendServer(options, object -> heard.add(types.get(VELOCITY).read(object).number("vX").orElseThrow())));
    }

    boolean say(double x) throws Exception {
      state.put(types.get(STATE).bytes(Map.of("baseOdomPose", Map.of("pose3D", Map.of("position", Map.of("x", x))))));
      return true;
    }

    @Override
    public void close() {
      component.close();
    }
  }

  private static void await(String what, Callable<Boolean> condition) throws Exception {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.call()) {
      assertTrue(System.nanoTime() < end, what);
      Thread.sleep(20);
    }
  }

  private int said() {
    return context.published.containsKey("base/state") ? context.published.get("base/state").size() : 0;
  }

  @SuppressWarnings("unchecked")
  private Sent drive() {
    CommandSink<Data> sink = (CommandSink<Data>) context.sinks.get("velocity");
    return sink == null ? new Sent.Refused("there is none") : sink.send(VelocityCommand.planar(0.2, 0));
  }

  private boolean isDegraded(String reason) {
    return context.links.peekLast() instanceof LinkState.Degraded d && d.reason().contains(reason);
  }

  @Test
  void a_component_that_is_started_again_is_heard_and_driven_again() throws Exception {
    await("a naming service without components is told", () -> isDegraded("no component"));
    try (Base first = new Base()) {
      await("it is connected", () -> context.links.peekLast() instanceof LinkState.Connected);
      context.demand("base/state", true);
      await("it is heard", () -> first.say(1) && said() >= 1);
      await("it is driven", () -> drive() instanceof Sent.Out && !first.heard.isEmpty());
    }
    await("nobody is driven", () -> drive() instanceof Sent.Refused);
    try (Base second = new Base()) {
      int before = said();
      await("it is heard again", () -> second.say(2) && said() > before);
      await("it is driven again", () -> drive() instanceof Sent.Out && !second.heard.isEmpty());
    }
  }

  @Test
  void components_go_on_without_their_naming_service() throws Exception {
    int port = naming.port();
    try (Base base = new Base()) {
      await("it is connected", () -> context.links.peekLast() instanceof LinkState.Connected);
      context.demand("base/state", true);
      await("it is heard", () -> base.say(1) && said() >= 1);
      await("it is driven", () -> base.say(1) && drive() instanceof Sent.Out && !base.heard.isEmpty());
      int commands = base.heard.size();
      naming.close();
      await("that is told", () -> isDegraded("components that are linked go on"));
      int before = said();
      await("it is heard all the same", () -> base.say(2) && said() > before);
      await("it is driven all the same",
          () -> base.say(2) && drive() instanceof Sent.Out && base.heard.size() > commands);
      naming = new NamingService(Peer.THREADS, InetAddress.getLoopbackAddress(), port);
      await("one that has forgotten all is told", () -> isDegraded("no component"));
    }
    try (Base again = new Base()) {
      int before = said();
      await("it is heard after all", () -> again.say(3) && said() > before);
    }
  }

  @Test
  @SuppressWarnings("unchecked")
  void states_are_parameters_and_what_drives_is_no_call() throws Exception {
    try (Base base = new Base()) {
      base.component.offer(SmartPattern.QUERY, "mode",
          List.of("SmartACE::smartStateRequest", "SmartACE::smartStateResponse"),
          new QueryServer(options, new StateSlave(types, List.of("Neutral", "Active"), state -> {})));
      await("it can be browsed", () -> context.browsers.containsKey("graph"));
      Browser browser = context.browsers.get("graph");
      await("it is found", () -> browser.list(Browser.Kind.PARAMETER).size() == 1);
      assertEquals("Neutral", browser.parameter("base/mode").orElseThrow());
      browser.setParameter("base/mode", "Active");
      assertEquals("Active", browser.parameter("base/mode").orElseThrow());
      assertEquals(List.of("base/mode"),
          browser.list(Browser.Kind.SERVICE).stream().map(Browser.Item::name).toList());
      ServiceReply reply = ((CallHandler<ServiceRequest, ServiceReply>) context.handlers.get("services"))
          .handle(SmartInvocation.of("base/mode", Map.of("command", 3)));
      assertTrue(reply.value().field("state_list").isPresent());
      Browser.Item node = browser.list(Browser.Kind.NODE).getFirst();
      assertTrue(browser.describe(node).facts().containsKey("drive"));
    }
  }

  @Test
  void what_is_not_described_says_what_to_do() throws Exception {
    try (Base base = new Base()) {
      base.component.offer(SmartPattern.PUSH, "ptu", List.of("DomainPTU::CommPTUState"),
          new PushServer(options, Duration.ZERO));
      await("that is told", () -> context.complaints.containsKey("base/ptu")
          && context.complaints.get("base/ptu").stream().anyMatch(each -> each.contains("DomainPTU.idl")));
    }
  }
}
