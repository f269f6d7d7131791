package org.robotui.uic.teleop.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.command.VelocityCommand;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeOutput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.LimitBar;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class TeleopSwtTest {
  private static final int WIDTH = 500;
  private static final int HEIGHT = 290;
  private static Display display;

  private final FakeUicContext context = new FakeUicContext("teleop", new TeleopType().schema());
  private final FakeOutput<VelocityCommand> output = context.output(TeleopType.CMD_VEL);
  private final TeleopUic uic = (TeleopUic) new TeleopType().create(context, context.settings().current());
  private final Rectangle stick = TeleopLayout.of(WIDTH, HEIGHT).stick();
  private Theme theme;
  private Shell shell;
  private Composite root;
  private PaintedCanvas canvas;
  private String note = "";

  @BeforeAll
  static void openDisplay() {
    display = TestDisplay.get();
  }

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, WIDTH, HEIGHT);
    root = (Composite) uic.createControl(shell, UiContext.of(theme, text -> note = text));
    canvas = (PaintedCanvas) root.getTabList()[0];
    shell.open();
    settle();
  }

  @AfterEach
  void close() {
    shell.dispose();
    uic.close();
    theme.dispose();
  }

  @Test
  void aDragUpDrivesForwardUntilTheButtonComesUp() {
    mouse(SWT.MouseDown, centre().x, centre().y, 1, 0);
    mouse(SWT.MouseMove, centre().x, stick.y, 0, SWT.BUTTON1);
    tick();
    assertTrue(output.sent().getLast().command().linear().x() > 0);
    assertEquals("control: you \u00b7 by hand max 0.40\u00a0m/s", note);
    mouse(SWT.MouseUp, centre().x, stick.y, 1, SWT.BUTTON1);
    assertEquals(1, output.releases());
  }

  @Test
  void theKnobFollowsTheHandAndSpringsBack() {
    RGB accent = theme.color(Role.ACCENT).getRGB();
    Point up = new Point(centre().x, stick.y + 30);
    assertNotEquals(accent, pixel(up));
    mouse(SWT.MouseDown, up.x, up.y, 1, 0);
    until(() -> pixel(up).equals(accent));
    mouse(SWT.MouseUp, up.x, up.y, 1, SWT.BUTTON1);
    until(() -> !pixel(up).equals(accent));
  }

  @Test
  void keysDriveAndTheirReleaseStops() {
    key(SWT.KeyDown, 'w', 0);
    key(SWT.KeyDown, SWT.ARROW_LEFT, 0);
    tick();
    VelocityCommand command = output.sent().getLast().command();
    assertTrue(command.linear().x() > 0 && command.angular().z() > 0, command.toString());
    key(SWT.KeyUp, 'w', 0);
    key(SWT.KeyUp, SWT.ARROW_LEFT, 0);
    until(() -> output.releases() == 1);
  }

  @Test
  void keysWithControlAreShortcutsOfTheWindow() {
    key(SWT.KeyDown, 'w', SWT.CTRL);
    tick();
    assertTrue(output.sent().isEmpty());
  }

  @Test
  void lostFocusEndsTheDrive() {
    key(SWT.KeyDown, 'w', 0);
    tick();
    canvas.notifyListeners(SWT.FocusOut, new Event());
    assertEquals(1, output.releases());
  }

  @Test
  void aClosedViewEndsTheDrive() {
    key(SWT.KeyDown, 'w', 0);
    tick();
    canvas.getParent().dispose();
    assertEquals(1, output.releases());
  }

  @Test
  void spaceLatchesTheStopAndTheButtonReleasesIt() {
    key(SWT.KeyDown, ' ', 0);
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().stoppedBy());
    press(TeleopFooter.Button.RELEASE_STOP);
    assertEquals(Optional.empty(), context.authority().stoppedBy());
  }

  @Test
  void whatAnnaDrivesIsAskedForInTheViewItself() {
    context.authority().take(FakeAuthority.ANNA, false);
    tick();
    press(TeleopFooter.Button.ASK);
    assertEquals(Optional.of(FakeAuthority.ANNA), context.authority().holder());
    press(TeleopFooter.Button.TAKE_OVER);
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().holder());
    press(TeleopFooter.Button.RELEASE_CONTROL);
    assertEquals(Optional.empty(), context.authority().holder());
  }

  @Test
  void theBarsSetTheLimitsInTheSettings() {
    LimitBar bar = Arrays.stream(root.getChildren()).filter(LimitBar.class::isInstance).map(LimitBar.class::cast)
        .findFirst().orElseThrow();
    Event event = new Event();
    event.button = 1;
    event.x = bar.getBounds().width / 2;
    bar.notifyListeners(SWT.MouseDown, event);
    assertEquals(TeleopType.HIGHEST_LINEAR / 2, context.settings().current().number(TeleopType.MAX_LINEAR), 0.01);
  }

  @Test
  void theFocusOfThePartGoesToTheStickSoThatKeysDrive() {
    assertEquals(canvas, display.getFocusControl(), "when the window opens");
    root.getChildren()[0].forceFocus();
    root.setFocus();
    settle();
    assertEquals(canvas, display.getFocusControl());
  }

  private Point centre() {
    return new Point(stick.x + stick.width / 2, stick.y + stick.height / 2);
  }

  private void tick() {
    uic.tick(System.nanoTime());
    uic.refresh();
    settle();
  }

  private void mouse(int type, int x, int y, int button, int state) {
    Event event = new Event();
    event.x = x;
    event.y = y;
    event.button = button;
    event.stateMask = state;
    canvas.notifyListeners(type, event);
  }

  private void key(int type, int keyCode, int state) {
    Event event = new Event();
    event.keyCode = keyCode;
    event.stateMask = state;
    canvas.notifyListeners(type, event);
  }

  private void press(TeleopFooter.Button wanted) {
    settle();
    QuietButton button = Arrays.stream(root.getChildren()).filter(QuietButton.class::isInstance)
        .map(QuietButton.class::cast).toList().get(wanted.ordinal());
    assertTrue(button.isVisible(), wanted::name);
    button.press();
  }

  private RGB pixel(Point at) {
    canvas.update();
    settle();
    Image image = new Image(display, WIDTH, HEIGHT);
    GC gc = new GC(canvas);
    gc.copyArea(image, 0, 0);
    gc.dispose();
    ImageData data = image.getImageData();
    image.dispose();
    return data.palette.getRGB(data.getPixel(at.x, at.y));
  }

  private static void settle() {
    boolean more = true;
    while (more) {
      more = display.readAndDispatch();
    }
  }

  private static void until(BooleanSupplier condition) {
    long end = System.nanoTime() + 5_000_000_000L;
    while (!condition.getAsBoolean() && System.nanoTime() < end) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
    assertTrue(condition.getAsBoolean());
  }
}
