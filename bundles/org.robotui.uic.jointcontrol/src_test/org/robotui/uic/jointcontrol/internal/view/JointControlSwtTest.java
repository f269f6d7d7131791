package org.robotui.uic.jointcontrol.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.InputState;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeOutput;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.jointcontrol.internal.Robots;
import org.robotui.uic.jointcontrol.internal.model.Aim;
import org.robotui.uic.jointcontrol.internal.model.ControlModel;
import org.robotui.uic.jointcontrol.internal.model.Grid;
import org.robotui.uic.jointcontrol.internal.model.JointColumn;
import org.robotui.uic.jointcontrol.internal.model.JointDriver;
import org.robotui.uic.jointcontrol.internal.model.Phase;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class JointControlSwtTest implements Wishes {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 500;
  private static final double KNOB = (-0.72 + 2.6) / 5.2;
  private static final String ELBOW = "arm/arm_2";

  private final Display display = TestDisplay.get();
  private final FakeAuthority authority = new FakeAuthority("Keira");
  private final FakeOutput<JointCommand> output = new FakeOutput<>(authority);
  private final FakeInput<JointControl> control = new FakeInput<>();
  private final FakeInput<JointModel> described = new FakeInput<>();
  private final JointDriver driver = new JointDriver(output, FakeAuthority.YOU, this::speed);
  private final ControlModel model = new ControlModel(control, described, driver, this::degrees);
  private Theme theme;
  private Shell shell;
  private Text elsewhere;
  private JointsSurface surface;
  private String note = "";
  private double speed = 0.2;
  private long now;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout(SWT.VERTICAL));
    shell.setBounds(0, 0, WIDTH, 2 * HEIGHT);
    described.put(Robots.armModel());
    control.put(Robots.arm());
    model.tick(0);
    surface = new JointsSurface(shell, UiContext.of(theme, text -> note = text), model, driver, this);
    elsewhere = new Text(shell, SWT.NONE);
    shell.open();
    surface.control().setFocus();
    settle();
    surface.prepare();
    surface.show();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aDragWithoutControlMovesNothing() {
    drag(0.9);
    tick();
    assertTrue(output.sent().isEmpty());
    assertEquals("9 joints \u00b7 10.0\u00a0Hz", note);
  }

  @Test
  void theSwitchAsksAndADragThenMovesOneJoint() {
    surface.bar().drive().press();
    drag(0.9);
    tick();
    assertTrue(output.sent().isEmpty());
    drive();
    drag(0.75);
    tick();
    List<JointCommand.Joint> sent = output.sent().getLast().command().joints();
    assertEquals(List.of("arm_2"), sent.stream().map(JointCommand.Joint::name).toList());
    assertEquals(1.3, goal(), 0.05);
  }

  @Test
  void aPressBesideTheKnobSelectsAndMovesNothing() {
    drive();
    mouse(SWT.MouseDown, 0.9, 1, 0);
    mouse(SWT.MouseMove, 0.8, 0, SWT.BUTTON1);
    mouse(SWT.MouseUp, 0.8, 1, SWT.BUTTON1);
    tick();
    assertTrue(output.sent().isEmpty());
    assertEquals(ELBOW, surface.list().selected().getFirst().key());
  }

  @Test
  void aPressOnTheKnobAloneMovesNothing() {
    drive();
    mouse(SWT.MouseDown, KNOB + 0.02, 1, 0);
    mouse(SWT.MouseUp, KNOB + 0.02, 1, SWT.BUTTON1);
    tick();
    assertTrue(output.sent().isEmpty());
  }

  @Test
  void aJogEndsWhenTheButtonComesUp() {
    drive();
    driver.jog(true);
    surface.again();
    mouse(SWT.MouseDown, 0.9, 1, 0);
    tick();
    assertTrue(aim().isMoving());
    mouse(SWT.MouseUp, 0.9, 1, SWT.BUTTON1);
    assertFalse(aim().isMoving());
  }

  @Test
  void aHeldKeyJogsUntilItComesUp() {
    drive();
    driver.jog(true);
    surface.again();
    surface.select(ELBOW);
    key(SWT.KeyDown, SWT.ARROW_RIGHT, '\0');
    tick();
    assertTrue(aim().isMoving());
    key(SWT.KeyUp, SWT.ARROW_RIGHT, '\0');
    until(() -> !aim().isMoving());
  }

  @Test
  void arrowsStepFinely() {
    drive();
    surface.select(ELBOW);
    key(SWT.KeyDown, SWT.ARROW_RIGHT, '\0');
    key(SWT.KeyDown, SWT.ARROW_RIGHT, '\0');
    assertEquals(-0.72 + Math.toRadians(1), goal(), 1e-9);
  }

  @Test
  void aTypedNumberIsTheTarget() {
    drive();
    surface.select(ELBOW);
    key(SWT.KeyDown, '3', '3');
    Text field = surface.editor().field().orElseThrow();
    assertEquals("3", field.getText());
    field.setText("30");
    Event enter = new Event();
    enter.keyCode = SWT.CR;
    field.notifyListeners(SWT.KeyDown, enter);
    assertEquals(Math.toRadians(30), goal(), 1e-9);
    assertTrue(surface.editor().field().isEmpty());
  }

  @Test
  void whatIsNoNumberStaysInTheField() {
    drive();
    surface.select(ELBOW);
    key(SWT.KeyDown, SWT.CR, '\r');
    Text field = surface.editor().field().orElseThrow();
    field.setText("fast");
    Event enter = new Event();
    enter.keyCode = SWT.CR;
    field.notifyListeners(SWT.KeyDown, enter);
    assertTrue(surface.editor().field().isPresent());
    assertTrue(driver.look().aims().isEmpty());
  }

  @Test
  void spaceStopsTheRobot() {
    drive();
    key(SWT.KeyDown, ' ', ' ');
    assertEquals(Optional.of(FakeAuthority.YOU), authority.stoppedBy());
    assertFalse(driver.look().driving());
  }

  @Test
  void escapeGivesControlBack() {
    drive();
    key(SWT.KeyDown, SWT.ESC, '\u001b');
    assertFalse(driver.look().driving());
    assertTrue(authority.holder().isEmpty());
  }

  @Test
  void lostFocusEndsDriving() {
    drive();
    elsewhere.forceFocus();
    surface.refresh();
    until(() -> !driver.look().driving());
    assertTrue(driver.look().told().orElse("").contains("focus"));
  }

  @Test
  void aHiddenViewEndsDriving() {
    drive();
    surface.control().dispose();
    assertFalse(driver.look().driving());
  }

  @Test
  void staleBarsCannotBeTouched() {
    drive();
    control.state(new InputState.Stale(1, "silent"));
    tick();
    drag(0.9);
    tick();
    assertTrue(output.sent().isEmpty());
    assertFalse(surface.detail().stiffness().text().getEnabled());
  }

  @Test
  void aTypedStiffnessIsSent() {
    drive();
    surface.select(ELBOW);
    Text field = surface.detail().stiffness().text();
    assertTrue(field.getEnabled());
    field.setText("250");
    field.notifyListeners(SWT.DefaultSelection, new Event());
    assertEquals(OptionalDouble.of(250), aim().stiffness());
  }

  @Test
  void aClickOnAChainClosesIt() {
    Rectangle head = surface.list().bounds("chain arm").orElseThrow();
    Event press = new Event();
    press.button = 1;
    press.x = 20;
    press.y = head.y + 5;
    surface.list().control().notifyListeners(SWT.MouseDown, press);
    assertTrue(surface.list().bounds(ELBOW).isEmpty());
    assertTrue(surface.list().bounds("gripper/finger").isPresent());
  }

  @Test
  void theFilterLeavesWhatFits() {
    surface.bar().filter().words("finger");
    assertEquals(2, surface.list().rows().size());
  }

  private Aim aim() {
    return driver.look().aims().get("arm_2");
  }

  private double goal() {
    return aim().goal();
  }

  private void drive() {
    if (driver.look().phase() == Phase.MONITOR) {
      driver.toggle();
    }
    driver.confirm(true);
    assertTrue(driver.look().driving());
    surface.again();
  }

  private void drag(double share) {
    mouse(SWT.MouseDown, KNOB, 1, 0);
    mouse(SWT.MouseMove, share, 0, SWT.BUTTON1);
    mouse(SWT.MouseUp, share, 1, SWT.BUTTON1);
  }

  private void mouse(int type, double share, int button, int state) {
    Rectangle row = surface.list().bounds(ELBOW).orElseThrow();
    Grid.Place place = surface.grid().find(JointColumn.RANGE).orElseThrow();
    Event event = new Event();
    event.button = button;
    event.stateMask = state;
    event.x = row.x + RangeBar.x(place.left(), place.width(), share);
    event.y = row.y + row.height / 2;
    surface.list().control().notifyListeners(type, event);
  }

  private void key(int type, int code, char character) {
    Event event = new Event();
    event.keyCode = code;
    event.character = character;
    Control list = surface.list().control();
    list.notifyListeners(type, event);
  }

  private void tick() {
    now += 50_000_000L;
    model.tick(now);
    surface.prepare();
    surface.show();
  }

  private void settle() {
    while (display.readAndDispatch()) {
      continue;
    }
  }

  private void until(BooleanSupplier condition) {
    long end = System.nanoTime() + 10_000_000_000L;
    display.timerExec(10_100, () -> {});
    while (!condition.getAsBoolean() && System.nanoTime() < end) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
    assertTrue(condition.getAsBoolean());
  }

  @Override
  public boolean degrees() {
    return true;
  }

  @Override
  public void degrees(boolean wanted) {
    throw new AssertionError("nobody asked for " + wanted);
  }

  @Override
  public double speed() {
    return speed;
  }

  @Override
  public void speed(double share) {
    speed = share;
  }
}
