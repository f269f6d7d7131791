package org.robotui.uic.jointcontrol.internal.view;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.LimitBar;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.jointcontrol.internal.model.ControlLook;
import org.robotui.uic.jointcontrol.internal.model.JointDriver;
import org.robotui.uic.jointcontrol.internal.model.Phase;

/** The line above the table: the switch, how joints are driven, units and filter. Display thread. */
final class DriveBar {
  private static final int COLUMNS = 7;
  private static final int SPEED_WIDTH = 80;
  private static final int SPEED_WORDS = 66;
  private static final int WIDEST_FILTER = 160;
  private static final int ROOM_FOR_SPEED = 560;
  private static final int ROOM_FOR_BOTH = 680;
  private static final int ROOM_FOR_FILTER = 380;
  private static final int ROOM_FOR_DEGREES = 220;
  private static final int PERCENT = 100;

  private final Composite root;
  private final QuietButton drive;
  private final QuietButton target;
  private final QuietButton jog;
  private final LimitBar speed;
  private final PlainLabel speedWords;
  private final QuietButton degrees;
  private final FilterField filter;

  DriveBar(Composite parent, Theme theme, JointDriver driver, Wishes wishes, Runnable done, Consumer<String> search) {
    root = Boxes.bar(parent, theme, COLUMNS + 1);
    ((GridLayout) root.getLayout()).horizontalSpacing = 2 * Theme.STEP;
    drive = button(theme, () -> run(driver::toggle, done)).text("Drive joints").icon(Icon.STEER)
        .hint("Take control of the robot and move joints by hand; asks first");
    target = button(theme, () -> run(() -> driver.jog(false), done)).text("Target")
        .hint("Joints go where you set them, and stay there");
    jog = button(theme, () -> run(() -> driver.jog(true), done)).text("Jog")
        .hint("Joints move only while you hold the bar or a key");
    speed = new LimitBar(root, theme, 1, wishes::speed);
    speed.setToolTipText("How fast joints are moved at most, as a share of their speed: drag, wheel or arrow keys");
    GridData wide = Boxes.middle();
    wide.widthHint = SPEED_WIDTH;
    speed.setLayoutData(wide);
    speedWords = new PlainLabel(root, SWT.NONE, theme, Face.SMALL, Role.DIM);
    GridData words = Boxes.middle();
    words.widthHint = SPEED_WORDS;
    speedWords.setLayoutData(words);
    degrees =
        button(theme, () -> wishes.degrees(!wishes.degrees())).text("Degrees").hint("Angles in degrees or radians");
    PlainLabel gap = new PlainLabel(root, SWT.NONE, theme, Face.SMALL, Role.DIM);
    gap.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    filter = new FilterField(root, theme, "Filter joints", search);
    GridData right = new GridData(SWT.END, SWT.CENTER, false, false);
    right.widthHint = WIDEST_FILTER;
    filter.setLayoutData(right);
  }

  FilterField filter() {
    return filter;
  }

  QuietButton drive() {
    return drive;
  }

  void show(ControlLook look) {
    boolean driving = look.drive().phase() == Phase.DRIVING;
    int room = root.getClientArea().width;
    drive.checked(look.drive().phase() != Phase.MONITOR);
    drive.setEnabled(driving || look.drive().blocked().isEmpty());
    target.checked(!look.drive().jog());
    jog.checked(look.drive().jog());
    speed.value(look.drive().speed());
    speedWords.setText("speed " + Math.round(look.drive().speed() * PERCENT) + "\u00a0%");
    degrees.checked(look.degrees());
    boolean changed = false;
    for (QuietButton button : List.of(target, jog)) {
      changed |= Boxes.seen(button, driving);
    }
    changed |= Boxes.seen(speed, driving && room >= ROOM_FOR_SPEED);
    changed |= Boxes.seen(speedWords, driving && room >= ROOM_FOR_SPEED);
    changed |= Boxes.seen(degrees, room >= (driving ? ROOM_FOR_FILTER : ROOM_FOR_DEGREES));
    changed |= Boxes.seen(filter, room >= (driving ? ROOM_FOR_BOTH : ROOM_FOR_FILTER));
    if (changed) {
      // Columns of what is not seen would keep the filter from the right edge by the room between them.
      ((GridLayout) root.getLayout()).numColumns =
          (int) Stream.of(root.getChildren()).filter(Control::getVisible).count();
      root.layout();
    }
  }

  private QuietButton button(Theme theme, Runnable pressed) {
    QuietButton made = new QuietButton(root, theme, pressed);
    made.setLayoutData(Boxes.middle());
    return made;
  }

  private static void run(Runnable action, Runnable done) {
    action.run();
    done.run();
  }
}
