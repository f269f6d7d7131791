package org.robotui.workbench.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.FrameworkUtil;
import org.osgi.framework.ServiceRegistration;
import org.robotui.api.RficType;
import org.robotui.api.UicType;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.workbench.tests.healthy.HealthyView;

/**
 * A view of a bundle that misbehaves on the display thread of the real workbench, beside a healthy one. Runs on that
 * thread.
 */
class FencedWindowTest {
  private static final Duration PATIENCE = Duration.ofSeconds(40);
  private static final String GATE = "org.robotui.tests.badwindow.gate";
  private static final String ORIGIN = "(bundle org.robotui.tests.badwindow, class org.robotui.tests.badwindow.BadView";

  private final Host host = service(Host.class);
  private final HealthyView healthy = new HealthyView();
  private final Rover rover = new Rover();
  private final Joystick joystick = new Joystick();
  private final List<ServiceRegistration<?>> types = new ArrayList<>();
  private final List<String> alerts = new CopyOnWriteArrayList<>();
  private @TempDir Path folder;
  private Bundle bad;
  private Host.Subscription listening;

  @BeforeEach
  void start() throws Exception {
    bad = BadBundle.packed().install();
    types.add(context().registerService(RficType.class, rover, null));
    types.add(context().registerService(UicType.class, healthy, null));
    types.add(context().registerService(UicType.class, joystick, null));
    listening = host.listen(new HostListener() {
      @Override
      public void alert(String ruic, String message) {
        alerts.add(message);
      }
    });
  }

  @AfterEach
  void end() throws Exception {
    host.ruics().forEach(Ruic::remove);
    until(() -> host.ruics().isEmpty(), "the robot is removed");
    System.clearProperty(GATE);
    listening.close();
    types.forEach(ServiceRegistration::unregister);
    bad.uninstall();
  }

  private void show(String settings) throws Exception {
    Path file = Files.writeString(folder.resolve("robot.yaml"), """
        ruics:
          Keira:
            safety:
              Keira: {lease: false}
            rfics:
              base: {type: rover}
            uics:
              bad: {type: badwindow, %s}
              good: {type: healthy}
              stick: {type: joystick}
            layout:
              row:
                - {view: bad}
                - {view: good}
        """.formatted(settings));
    CompletableFuture<List<Problem>> problems = CompletableFuture.supplyAsync(() -> host.load(file));
    until(problems::isDone, "the file is read");
    assertEquals(List.of(), problems.join());
    until(() -> {
      boolean shown = !healthy.controls().isEmpty();
      if (!shown) {
        Driver.pressFirstRobot(window());
      }
      return shown;
    }, "the healthy view is shown");
  }

  private void assertFencedFor(String what) {
    until(() -> status("bad").state() == RuicState.FAILED, "it has failed");
    String reason = status("bad").reason();
    assertTrue(reason.contains(what) && reason.contains(ORIGIN), reason);
    until(() -> alerts.stream().anyMatch(a -> a.startsWith("bad failed: ") && a.contains(ORIGIN)), "the user is told");
    until(() -> !widgets("MessagePane").isEmpty(), "it says so in its place");
    assertTheOthersGoOn();
  }

  private void assertTheOthersGoOn() {
    int ticks = joystick.ticks().get();
    until(() -> joystick.ticks().get() > ticks + 20, "the other goes on");
    until(() -> healthy.controls().stream().anyMatch(c -> !c.isDisposed() && c.isVisible()),
        "the other view is still shown");
    assertEquals(RuicState.SELECTED, status("good").state());
  }

  @Test
  void anExceptionInPaint() throws Exception {
    show("in: paint, does: throw");
    assertFencedFor("java.lang.IllegalStateException: a bug");
  }

  @Test
  void aStackOverflowInPaint() throws Exception {
    show("in: paint, does: overflow");
    assertFencedFor("java.lang.StackOverflowError");
  }

  @Test
  void aMissingClassInRefresh() throws Exception {
    show("in: refresh, does: no_class, once: " + GATE);
    openTheGate();
    assertFencedFor("java.lang.NoClassDefFoundError");
  }

  @Test
  void anAssertionInRefresh() throws Exception {
    show("in: refresh, does: assert, once: " + GATE);
    openTheGate();
    assertFencedFor("java.lang.AssertionError");
  }

  @Test
  void anExceptionInCreateControl() throws Exception {
    show("in: createControl, does: throw");
    assertFencedFor("java.lang.IllegalStateException: a bug");
  }

  @Test
  void aStackOverflowInCreateControl() throws Exception {
    show("in: createControl, does: overflow");
    assertFencedFor("java.lang.StackOverflowError");
  }

  @Test
  void anExceptionInActions() throws Exception {
    show("in: actions, does: throw");
    assertFencedFor("java.lang.IllegalStateException: a bug");
  }

  @Test
  void moreMemoryThanThereIsInPaint() throws Exception {
    show("in: paint, does: hoard");
    assertFencedFor("java.lang.OutOfMemoryError");
  }

  @Test
  void aPaintThatBlocksForSecondsStopsTheRobotForThatTime() throws Exception {
    show("in: paint, does: block_3, once: " + GATE);
    until(rover::isMoving, "it moves");
    openTheGate();
    // A busy machine may hold the display up for a moment as well, and is told of as well.
    awaitAnswer();
    assertTrue(alerts.stream().anyMatch(a -> a.endsWith("; what its windows moved is stopped")), alerts.toString());
    until(rover::isMoving, "it moves again");

    assertTrue(rover.longestStandNanos() > 1_000_000_000L, "it stood still, for " + rover.longestStandNanos());
    assertTheOthersGoOn();
    assertEquals(RuicState.SELECTED, status("bad").state(), "a short block is no failure");
  }

  @Test
  void aPaintThatBlocksForFifteenSecondsIsRememberedForTheNextStart() throws Exception {
    show("in: paint, does: block_15, once: " + GATE);
    until(rover::isMoving, "it moves");
    int ticks = joystick.ticks().get();
    openTheGate();
    awaitAnswer();
    assertTrue(joystick.ticks().get() > ticks + 100,
        "workers went on meanwhile, with " + (joystick.ticks().get() - ticks));
    until(rover::isMoving, "it moves again");

    assertTrue(rover.longestStandNanos() > 10_000_000_000L, "it stood still, for " + rover.longestStandNanos());
    Path suspects = Path.of(System.getProperty("robotui.state")).resolve("suspect-bundles.txt");
    until(() -> Files.exists(suspects), "it is remembered");
    assertEquals(List.of("org.robotui.tests.badwindow"), Files.readAllLines(suspects));
    Files.delete(suspects);
    assertTheOthersGoOn();
  }

  private static void openTheGate() {
    System.setProperty(GATE, "true");
  }

  private void awaitAnswer() {
    String told = "the display answers again, after \\d+\\.\\d s; bundle org.robotui.tests.badwindow held it up";
    until(() -> alerts.stream().anyMatch(a -> a.matches(told)), "the user is told how long, and who it was");
  }

  private ComponentStatus status(String id) {
    return host.ruics().getFirst().snapshot().components().stream().filter(c -> c.id().equals(id)).findFirst()
        .orElseThrow();
  }

  private static IWorkbenchWindow window() {
    return PlatformUI.getWorkbench().getWorkbenchWindows()[0];
  }

  private static List<Control> widgets(String type) {
    return Driver.widgets(window(), type);
  }

  private void until(BooleanSupplier condition, String what) {
    Driver.until(PATIENCE, condition,
        () -> what + "; there is " + host.ruics().stream().map(Ruic::snapshot).toList() + alerts);
  }

  private static <S> S service(Class<S> type) {
    return Optional.ofNullable(context().getServiceReference(type)).map(context()::getService).orElseThrow();
  }

  private static BundleContext context() {
    return FrameworkUtil.getBundle(FencedWindowTest.class).getBundleContext();
  }
}
