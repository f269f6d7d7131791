package org.robotui.uic.postures.internal.view;

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
import org.robotui.ui.control.LimitBar;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.postures.internal.model.PosturesLook;

/** The line above the postures: store, run and stop, and how. Display thread. */
final class PlayBar {
  private static final int COLUMNS = 6;
  private static final int SPEED_WIDTH = 80;
  private static final int SPEED_WORDS = 74;
  private static final int ROOM_FOR_SPEED = 520;
  private static final int ROOM_FOR_GUIDE = 340;
  private static final int PERCENT = 100;

  private final Composite root;
  private final QuietButton store;
  private final QuietButton play;
  private final QuietButton loop;
  private final QuietButton guide;
  private final LimitBar speed;
  private final PlainLabel speedWords;

  /** What can be done there. */
  interface Deeds {
    void store();

    void play();

    void loop(boolean wanted);

    void guide(boolean wanted);

    void speed(double share);
  }

  PlayBar(Composite parent, Theme theme, Deeds deeds) {
    root = Boxes.bar(parent, theme, COLUMNS);
    ((GridLayout) root.getLayout()).horizontalSpacing = 2 * Theme.STEP;
    play = button(new QuietButton(root, theme, deeds::play));
    store = button(new QuietButton(root, theme, deeds::store)).text("Store").icon(Icon.PLUS)
        .hint("Keep where the joints are now as a posture (Insert)");
    loop = button(new QuietButton(root, theme, () -> deeds.loop(!isLooped()))).text("Loop").icon(Icon.LOOP)
        .hint("The first posture follows the last one, until it is stopped");
    guide = button(new QuietButton(root, theme, () -> deeds.guide(!isGuided()))).text("By hand")
        .hint("Joints hold their weight and can be moved by hand, to store what they reach");
    speed = new LimitBar(root, theme, 1, deeds::speed);
    speed.setToolTipText("How fast joints go at most, as a share of their speed: drag, wheel or arrow keys");
    GridData wide = new GridData(SWT.END, SWT.CENTER, true, false);
    wide.widthHint = SPEED_WIDTH;
    speed.setLayoutData(wide);
    speedWords = new PlainLabel(root, SWT.NONE, theme, Face.SMALL, Role.DIM);
    GridData words = Boxes.middle();
    words.widthHint = SPEED_WORDS;
    speedWords.setLayoutData(words);
  }

  private boolean isLooped() {
    return loop.isChecked();
  }

  private boolean isGuided() {
    return guide.isChecked();
  }

  QuietButton play() {
    return play;
  }

  QuietButton store() {
    return store;
  }

  void show(PosturesLook look) {
    int room = root.getClientArea().width;
    play.text(look.playing() ? "Stop" : "Run").icon(look.playing() ? Icon.STOP : Icon.PLAY)
        .hint(look.playing() ? "End it: the joints come to rest (Esc)"
            : look.blocked().orElse("Go through all postures, one after the other"));
    play.setEnabled(look.playing() || look.blocked().isEmpty());
    store.setEnabled(look.storable());
    loop.checked(look.loop());
    guide.checked(look.guiding().orElse(false));
    speed.value(look.speed());
    speedWords.setText("speed " + Math.round(look.speed() * PERCENT) + "\u00a0%");
    boolean changed = Boxes.seen(guide, look.guiding().isPresent() && room >= ROOM_FOR_GUIDE);
    for (Control part : new Control[]{speed, speedWords}) {
      changed |= Boxes.seen(part, room >= ROOM_FOR_SPEED);
    }
    if (changed) {
      ((GridLayout) root.getLayout()).numColumns =
          (int) Stream.of(root.getChildren()).filter(Control::getVisible).count();
    }
    root.layout();
  }

  private static QuietButton button(QuietButton made) {
    made.setLayoutData(Boxes.middle());
    return made;
  }
}
