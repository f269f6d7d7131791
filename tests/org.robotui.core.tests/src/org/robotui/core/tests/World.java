package org.robotui.core.tests;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.junit.jupiter.api.Assertions;
import org.osgi.framework.BundleException;
import org.osgi.framework.ServiceRegistration;
import org.osgi.util.tracker.ServiceTracker;
import org.robotui.api.ComponentType;
import org.robotui.api.RficType;
import org.robotui.api.TextUic;
import org.robotui.api.UicType.Surface;
import org.robotui.api.UicType;
import org.robotui.api.command.Principal;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Match;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;

/** The real core, started anew, in the real framework; what a test took out of the framework is back after closing. */
final class World implements AutoCloseable {
  static final String CORE = "org.robotui.core";
  static final String TEXT = "org.robotui.uic.text";
  static final String SINGLE = "org.robotui.ruic.single";

  private static final List<String> PARTS = List.of("org.apache.felix.scr", CORE, TEXT, SINGLE, "org.robotui.message",
      "org.robotui.message.data", "org.robotui.message.topic", "org.robotui.ros",
      "org.robotui.rfic.ros", "org.robotui.rtps", "org.robotui.ros2", "org.robotui.rfic.ros2", "org.robotui.player",
      "org.robotui.rfic.player", "org.robotui.lcm",
      "org.robotui.rfic.lcm", "org.robotui.carmen", "org.robotui.rfic.carmen", "org.robotui.yarp",
      "org.robotui.rfic.yarp", "org.robotui.smartsoft", "org.robotui.rfic.smartsoft");
  private static final long SERVICE_MILLIS = 60_000;

  private final Path folder;
  private final Map<ComponentType, ServiceRegistration<?>> types = new IdentityHashMap<>();
  private final List<String> alerts = new CopyOnWriteArrayList<>();
  private final Map<String, AtomicInteger> frames = new ConcurrentHashMap<>();
  private final Map<String, Installed> away = new TreeMap<>();
  private final Host host;

  World(Path folder) throws Exception {
    this.folder = folder;
    System.setProperty("robotui.state", folder.resolve("state").toString());
    Bundles.stop(CORE);
    for (String part : PARTS) {
      Bundles.start(part);
    }
    host = host();
    host.open(Surface.TEXT, new Principal("test", "Test", Principal.Kind.SCRIPT));
    host.listen(new HostListener() {
      @Override
      public void alert(String ruic, String message) {
        alerts.add(ruic + ": " + message);
      }

      @Override
      public void frameReady(String ruic, String uic) {
        frames.computeIfAbsent(ruic + "." + uic, key -> new AtomicInteger()).incrementAndGet();
      }
    });
  }

  private static Host host() throws InterruptedException {
    ServiceTracker<Host, Host> tracker = new ServiceTracker<>(Bundles.context(), Host.class, null);
    tracker.open();
    Host found = tracker.waitForService(SERVICE_MILLIS);
    tracker.close();
    Assertions.assertNotNull(found, "core offers no service");
    return found;
  }

  Host core() {
    return host;
  }

  /** Registers a type, as its bundle does when it starts. */
  void bring(RficType type) {
    types.put(type, Bundles.context().registerService(RficType.class, type, null));
  }

  /** Registers a type, as its bundle does when it starts. */
  void bring(UicType type) {
    types.put(type, Bundles.context().registerService(UicType.class, type, null));
  }

  /** Withdraws a type, as its bundle does when it stops. */
  void stopBringing(ComponentType type) {
    types.remove(type).unregister();
  }

  void uninstall(String bundle) throws BundleException, IOException {
    away.put(bundle, Bundles.uninstall(bundle));
  }

  void install(String bundle) throws BundleException {
    Bundles.install(away.remove(bundle));
  }

  /** Loads a configuration of one RUIC and selects it. */
  Ruic load(String yaml) throws IOException {
    List<Problem> problems = host.load(Files.writeString(folder.resolve("robot.yaml"), yaml));
    Assertions.assertTrue(problems.stream().noneMatch(p -> p.severity() == Problem.Severity.ERROR),
        problems.toString());
    Ruic ruic = keira();
    ruic.select("window");
    return ruic;
  }

  /** The RUIC that was loaded; the last one, where there are others beside it. */
  private Ruic keira() {
    return host.ruics().getLast();
  }

  private RuicSnapshot snapshot() {
    return keira().snapshot();
  }

  void awaitRuic(RuicState state) {
    Eventually.await("the RUIC is " + state, () -> snapshot().state() == state, this::snapshot);
  }

  void await(String component, RuicState state) {
    Eventually.await(component + " is " + state, () -> status(component).filter(s -> s.state() == state).isPresent(),
        this::snapshot);
  }

  private Optional<ComponentStatus> status(String component) {
    return snapshot().components().stream().filter(c -> c.id().equals(component)).findFirst();
  }

  /** Why a component failed. */
  String reason(String component) {
    return status(component).orElseThrow().reason();
  }

  Match awaitMatch(String port, Predicate<Match> condition) {
    Eventually.await(port + " is matched so", () -> match(port).filter(condition).isPresent(),
        () -> snapshot().matches());
    return match(port).orElseThrow();
  }

  private Optional<Match> match(String port) {
    return snapshot().matches().stream().filter(m -> m.port().toString().equals(port)).findFirst();
  }

  /** A port of a robot interface. */
  Optional<PortStatus> port(String port) {
    return snapshot().ports().stream().filter(p -> p.port().toString().equals(port)).findFirst();
  }

  /** The ports that robot interfaces offer now. */
  List<String> ports() {
    return snapshot().ports().stream().map(p -> p.port().toString()).toList();
  }

  /** What a view of the bundle of text shows, once it shows some word. */
  String awaitText(String view, String word) {
    Eventually.await(view + " shows " + word, () -> text(view).contains(word), () -> text(view));
    return text(view);
  }

  /** Waits for a text with some word that is as it should be: before the first value it names what is waited for. */
  void awaitText(String view, String word, Predicate<String> right) {
    Eventually.await(view + " shows " + word, () -> text(view).contains(word) && right.test(text(view)),
        () -> text(view));
  }

  private String text(String view) {
    return keira().uic(view).map(TextUic.class::cast)
        .map(v -> String.join("\n", v.lines(160, 60))).orElse("");
  }

  /** What the user was told. */
  List<String> alerts() {
    return alerts;
  }

  /** Waits until a view, by RUIC and id, has had something new to show so many times more. */
  void awaitFrames(String view, int more) {
    int before = frames(view);
    Eventually.await(view + " is shown", () -> frames(view) >= before + more, () -> frames);
  }

  private int frames(String view) {
    return frames.getOrDefault(view, new AtomicInteger()).get();
  }

  void awaitAlert(String word) {
    Eventually.await("the user is told of " + word, () -> alerts.stream().anyMatch(a -> a.contains(word)),
        () -> alerts);
  }

  /** Threads that live, by the beginning of their names. */
  static List<String> threads(String... prefixes) {
    return Thread.getAllStackTraces().keySet().stream().filter(Thread::isAlive).map(Thread::getName)
        .filter(n -> List.of(prefixes).stream().anyMatch(n::startsWith)).sorted().toList();
  }

  void awaitNoThread(String... prefixes) {
    Eventually.await("no thread is left", () -> threads(prefixes).isEmpty(), () -> threads(prefixes));
  }

  @Override
  public void close() throws Exception {
    Bundles.stop(CORE);
    types.values().forEach(ServiceRegistration::unregister);
    for (String bundle : List.copyOf(away.keySet())) {
      install(bundle);
    }
  }
}
