package org.robotui.workbench.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.eclipse.e4.ui.model.application.ui.menu.MMenuFactory;
import org.eclipse.e4.ui.workbench.renderers.swt.MenuManagerRenderer;
import org.eclipse.e4.ui.workbench.swt.factories.IRendererFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Control;
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
import org.robotui.workbench.tests.healthy.HealthyView;

/** Drives the real workbench and the real core with components of its own. Runs on the display thread. */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class WorkbenchTest {
  private static final Duration PATIENCE = Duration.ofSeconds(40);
  private static final AtomicInteger SENT = new AtomicInteger();
  private static final HealthyView VIEW = new HealthyView();
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
    until(() -> Math.abs((double) left.getSize().x / right.getSize().x - 3) < 0.2,
        "the views have three parts and one part of the room");
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

    until(() -> before.isDisposed() && shown().isPresent(), "the view is made anew");
    assertNotEquals(color, shown().orElseThrow().getBackground().getRGB());
    run("org.robotui.workbench.command.theme", Map.of("org.robotui.workbench.theme", "dark"));
    until(() -> shown().filter(c -> c.getBackground().getRGB().equals(color)).isPresent(), "it is as before");
  }

  @Test
  @Order(6)
  void aSecondWindowShowsAnotherRobotAndClosesAlone() throws Exception {
    IWorkbenchWindow second = PlatformUI.getWorkbench().openWorkbenchWindow("org.robotui.workbench.perspective", null);

    until(() -> !Driver.widgets(second, "TopBar").isEmpty(), "it has a bar of its own");
    assertEquals(0, Driver.widgets(second, "ViewStack").size());
    assertEquals(2, widgets("ViewStack").size());
    second.close();
    until(() -> PlatformUI.getWorkbench().getWorkbenchWindowCount() == 1, "it is closed");
  }

  @Test
  @Order(7)
  void ofTheMenusThatTheSearchFillsNothingIsKept() throws Exception {
    openAndCloseTheSearch();
    int before = keptOfMenus();
    for (int i = 0; i < 3; i++) {
      openAndCloseTheSearch();
    }
    assertEquals(before, keptOfMenus());
  }

  private void openAndCloseTheSearch() throws Exception {
    run("org.robotui.workbench.command.search", Map.of());
    List<Control> panes = widgets("SearchPane");
    assertEquals(1, panes.size());
    panes.getFirst().dispose();
  }

  /** What the platform contributed to menus, and remembers. */
  @SuppressWarnings("restriction") // the platform says it nowhere else
  private int keptOfMenus() {
    MenuManagerRenderer renderer = (MenuManagerRenderer) window.getService(IRendererFactory.class)
        .getRenderer(MMenuFactory.INSTANCE.createMenu(), null);
    return renderer.getContributionRecords().length;
  }

  @Test
  @Order(8)
  void theEndWaitsNoLongerThanItMayForARobotThatHangs() throws Exception {
    load("stuck");
    until(() -> host.ruics().size() == 2, "both are there");
    long start = System.nanoTime();

    CompletableFuture<List<String>> left = CompletableFuture.supplyAsync(() -> host.close(Duration.ofMillis(1500)));
    CompletableFuture<Long> end = left.thenApply(l -> System.nanoTime());
    until(end::isDone, "it has ended");

    // It may take 1.5 s. The rest is room for a busy machine; a robot that hangs would take for ever.
    assertTrue(end.join() - start < 6_000_000_000L, "in time");
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
              left: {type: healthy}
              right: {type: healthy}
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

  /**
   * Presses its row until core and the window have both taken it up: what the window shows at first may be the one of
   * before.
   */
  private void select(String name) {
    until(() -> {
      boolean shown = robot().snapshot().state() == RuicState.SELECTED && widgets("ViewStack").size() == 2
          && VIEW.controls().stream().filter(c -> !c.isDisposed()).count() == 2;
      if (!shown) {
        Driver.pressFirstRobot(window);
      }
      return shown;
    }, name + " is shown");
  }

  private static Optional<Control> shown() {
    return Optional.of(VIEW.controls().getLast()).filter(c -> !c.isDisposed());
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
    return Driver.widgets(window, type);
  }

  private static void until(BooleanSupplier condition, String what) {
    Driver.until(PATIENCE, condition, () -> what);
  }

  private static <S> S service(Class<S> type) {
    BundleContext context = FrameworkUtil.getBundle(WorkbenchTest.class).getBundleContext();
    return Optional.ofNullable(context.getServiceReference(type)).map(context::getService).orElseThrow();
  }
}
