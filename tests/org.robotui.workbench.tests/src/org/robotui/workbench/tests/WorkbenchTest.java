package org.robotui.workbench.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.eclipse.core.commands.ParameterizedCommand;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.commands.ICommandService;
import org.eclipse.ui.handlers.IHandlerService;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;
import org.osgi.framework.BundleContext;
import org.osgi.framework.FrameworkUtil;
import org.osgi.framework.ServiceRegistration;
import org.robotui.api.RficType;
import org.robotui.api.UicType;
import org.robotui.api.host.Host;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;

/** Drives the real workbench and the real core with components of its own. Runs on the display thread. */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class WorkbenchTest {
  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final AtomicInteger SENT = new AtomicInteger();
  private static final ProbeView VIEW = new ProbeView();
  private static final List<ServiceRegistration<?>> TYPES = new ArrayList<>();

  private final Host host = service(Host.class);
  private final IWorkbenchWindow window = PlatformUI.getWorkbench().getWorkbenchWindows()[0];
  private @TempDir Path folder;

  @BeforeAll
  static void registerTypes() {
    BundleContext context = FrameworkUtil.getBundle(WorkbenchTest.class).getBundleContext();
    TYPES.add(context.registerService(RficType.class, new ProbeRfic("probe", false, SENT), null));
    TYPES.add(context.registerService(RficType.class, new ProbeRfic("stuck", true, SENT), null));
    TYPES.add(context.registerService(UicType.class, VIEW, null));
  }

  @AfterAll
  static void withdrawTypes() {
    TYPES.forEach(ServiceRegistration::unregister);
  }

  @BeforeEach
  void load() throws Exception {
    load("probe");
    select("Probe");
  }

  @AfterEach
  void remove() {
    host.ruics().forEach(Ruic::remove);
    until(() -> host.ruics().isEmpty(), "the robot is removed");
  }

  @Test
  @Order(1)
  void thePartRealisesTheLayout() {
    assertEquals(2, widgets("ViewStack").size());
    Control left = VIEW.controls().get(VIEW.controls().size() - 2);
    Control right = VIEW.controls().getLast();
    until(() -> left.getSize().x > 0 && right.getSize().x > 0, "the views have room");
    assertEquals(3.0, (double) left.getSize().x / right.getSize().x, 0.2);
  }

  @Test
  @Order(2)
  void anUnselectedRobotHasNoControlsAndGoesOn() throws Exception {
    run("org.robotui.workbench.command.unselect", Map.of());

    until(() -> VIEW.controls().stream().allMatch(Control::isDisposed), "the controls are gone");
    until(() -> robot().snapshot().state() == RuicState.UNSELECTED, "core knows");

    select("Probe");
    assertEquals(2, widgets("ViewStack").size());
  }

  @Test
  @Order(3)
  void aRemovedRobotLeavesTheWindow() throws Exception {
    run("org.robotui.workbench.command.remove", Map.of());

    until(() -> host.ruics().isEmpty(), "the robot is gone");
    until(() -> widgets("ViewStack").isEmpty(), "its views are gone");
  }

  @Test
  @Order(4)
  void theStopIsLatchedFromAnyWidgetUntilReleased() throws Exception {
    until(() -> !robot().authorities().isEmpty(), "the robot can be commanded");
    Event event = new Event();
    event.keyCode = SWT.F12;
    window.getShell().notifyListeners(SWT.KeyDown, event);

    until(this::isStopped, "it is stopped");
    run("org.robotui.workbench.command.release", Map.of());
    until(() -> !isStopped(), "it is released");
  }

  @Test
  @Order(5)
  void theThemeIsSwitchedWhileItRuns() throws Exception {
    Control before = VIEW.controls().getLast();
    RGB color = before.getBackground().getRGB();

    run("org.robotui.workbench.command.theme", Map.of("org.robotui.workbench.theme", "light"));

    until(before::isDisposed, "the view is made anew");
    assertNotEquals(color, VIEW.controls().getLast().getBackground().getRGB());
    run("org.robotui.workbench.command.theme", Map.of("org.robotui.workbench.theme", "dark"));
    assertEquals(color, VIEW.controls().getLast().getBackground().getRGB());
  }

  @Test
  @Order(6)
  void aSecondWindowShowsAnotherRobotAndClosesAlone() throws Exception {
    IWorkbenchWindow second = PlatformUI.getWorkbench().openWorkbenchWindow("org.robotui.workbench.perspective", null);

    until(() -> !widgets(second, "TopBar").isEmpty(), "it has a bar of its own");
    assertEquals(0, widgets(second, "ViewStack").size());
    assertEquals(2, widgets("ViewStack").size());
    second.close();
    until(() -> PlatformUI.getWorkbench().getWorkbenchWindowCount() == 1, "it is closed");
  }

  @Test
  @Order(7)
  void theEndTakesLessThanTwoSecondsAlsoWhenARobotHangs() throws Exception {
    load("stuck");
    until(() -> host.ruics().size() == 2, "both are there");
    long start = System.nanoTime();

    CompletableFuture<List<String>> left = CompletableFuture.supplyAsync(() -> host.close(Duration.ofMillis(1500)));
    until(left::isDone, "it has ended");

    assertTrue(System.nanoTime() - start < 2_000_000_000L, "in less than two seconds");
    assertTrue(left.join().stream().anyMatch(l -> l.contains("stuck") || l.contains("Stuck")), left.join().toString());
  }

  private void load(String type) throws Exception {
    String name = Character.toUpperCase(type.charAt(0)) + type.substring(1);
    Path file = Files.writeString(folder.resolve(type + ".yaml"), """
        ruics:
          %s:
            rfics:
              base: {type: %s}
            uics:
              left: {type: probeview}
              right: {type: probeview}
            layout:
              row:
                - {view: left, weight: 3}
                - {view: right, weight: 1}
        """.formatted(name, type));
    CompletableFuture<List<Problem>> problems = CompletableFuture.supplyAsync(() -> host.load(file));
    until(problems::isDone, "the file is read");
    assertEquals(List.of(), problems.join());
    until(() -> host.ruics().stream().anyMatch(r -> r.name().equals(name)), "the robot is there");
  }

  /** Presses the first row of the navigator. */
  private void select(String name) {
    until(() -> !widgets("RobotList").isEmpty() && widgets("RobotList").getFirst().getSize().y > 0, name + " is listed");
    Event event = new Event();
    event.button = 1;
    event.y = 10;
    widgets("RobotList").getFirst().notifyListeners(SWT.MouseDown, event);
    until(() -> widgets("ViewStack").size() == 2, name + " is shown");
  }

  private Ruic robot() {
    return host.ruics().getFirst();
  }

  private boolean isStopped() {
    return robot().authorities().stream().allMatch(a -> a.stoppedBy().isPresent());
  }

  private void run(String command, Map<String, String> parameters) throws Exception {
    ICommandService commands = window.getService(ICommandService.class);
    ParameterizedCommand filled = ParameterizedCommand.generateCommand(commands.getCommand(command), parameters);
    window.getService(IHandlerService.class).executeCommand(filled, null);
  }

  private List<Control> widgets(String type) {
    return widgets(window, type);
  }

  private static List<Control> widgets(IWorkbenchWindow in, String type) {
    List<Control> found = new ArrayList<>();
    collect(in.getShell(), type, found);
    return found;
  }

  private static void collect(Composite above, String type, List<Control> found) {
    for (Control child : above.getChildren()) {
      if (child.getClass().getSimpleName().equals(type)) {
        found.add(child);
      }
      if (child instanceof Composite inner) {
        collect(inner, type, found);
      }
    }
  }

  private static void until(BooleanSupplier condition, String what) {
    Display display = Display.getCurrent();
    display.timerExec((int) PATIENCE.toMillis() + 50, () -> { });
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        fail("waited in vain: " + what);
      }
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
  }

  private static <S> S service(Class<S> type) {
    BundleContext context = FrameworkUtil.getBundle(WorkbenchTest.class).getBundleContext();
    return Optional.ofNullable(context.getServiceReference(type)).map(context::getService).orElseThrow();
  }
}
