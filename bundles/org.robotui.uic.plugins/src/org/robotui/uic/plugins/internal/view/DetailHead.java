package org.robotui.uic.plugins.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.data.control.Drives.Phase;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.plugins.internal.model.DrivesLine;
import org.robotui.uic.plugins.internal.model.PluginDetail;
import org.robotui.uic.plugins.internal.model.PluginLine;
import org.robotui.uic.plugins.internal.model.Verbs;

/** The name of what is selected, and what can be done with it. Display thread. */
final class DetailHead {
  private static final int HEIGHT = 28;

  private final Theme theme;
  private final Composite root;
  private final PaintedCanvas name;
  private final QuietButton start;
  private final QuietButton stop;
  private final QuietButton reload;
  private final QuietButton enable;
  private final QuietButton disable;
  private final QuietButton recover;
  private Optional<PluginDetail> shown = Optional.empty();

  DetailHead(Composite parent, Theme theme, Verbs verbs, Runnable done) {
    this.theme = theme;
    root = Boxes.bar(parent, theme, 7);
    name = new PaintedCanvas(root, theme, this::paint);
    GridData wide = new GridData(SWT.FILL, SWT.CENTER, true, false);
    wide.widthHint = 0;
    wide.heightHint = HEIGHT;
    name.setLayoutData(wide);
    start = button("Start", Icon.PLAY, () -> ask(verbs, Verb.START, done));
    stop = button("Stop", Icon.STOP, () -> ask(verbs, Verb.STOP, done));
    reload = button("Reload", Icon.RESTART, () -> ask(verbs, Verb.RELOAD, done))
        .hint("Loads it again from its library; it must not run");
    enable = button("Enable", Icon.PLAY, () -> askAll(verbs, Verb.ENABLE_DRIVES, done))
        .hint("Enables the drives that are disabled; joints hold where they are");
    disable = button("Disable", Icon.STOP, () -> askAll(verbs, Verb.DISABLE_DRIVES, done))
        .hint("Switches all motors off; no plugin may lead a joint");
    recover = button("Recover", Icon.RESTART, () -> askAll(verbs, Verb.RECOVER_DRIVES, done))
        .hint("Resets the faults and enables those drives again: mend the cause first");
  }

  QuietButton enable() {
    return enable;
  }

  QuietButton disable() {
    return disable;
  }

  QuietButton recover() {
    return recover;
  }

  QuietButton start() {
    return start;
  }

  QuietButton reload() {
    return reload;
  }

  void show(PluginDetail detail) {
    shown = Optional.of(detail);
    boolean on = detail.plugin().filter(PluginLine::isOn).isPresent();
    boolean plugin = detail.plugin().isPresent();
    boolean drives = detail.drives().isPresent();
    if (Boxes.seen(start, plugin && !on) | Boxes.seen(stop, plugin && on) | Boxes.seen(reload, plugin)
        | Boxes.seen(enable, drives) | Boxes.seen(disable, drives) | Boxes.seen(recover, drives)) {
      root.layout();
    }
    enable.setEnabled(isPossible(detail, Phase.DISABLED));
    disable.setEnabled(isPossible(detail, Phase.ENABLED) || isPossible(detail, Phase.ENABLING));
    recover.setEnabled(isPossible(detail, Phase.FAULT));
    boolean switchable = detail.usable() && detail.plugin().filter(PluginLine::isSwitchable).isPresent();
    start.setEnabled(switchable);
    stop.setEnabled(switchable);
    reload.setEnabled(detail.usable() && detail.plugin().filter(PluginLine::isReloadable).isPresent());
    name.redraw();
  }

  private static boolean isPossible(PluginDetail detail, Phase phase) {
    return detail.usable() && detail.drives().filter(drives -> !drives.pending() && drives.has(phase)).isPresent();
  }

  private static void askAll(Verbs verbs, Verb verb, Runnable done) {
    verbs.ask(DrivesLine.ALL, verb, "");
    done.run();
  }

  private void ask(Verbs verbs, Verb verb, Runnable done) {
    shown.flatMap(PluginDetail::plugin).ifPresent(plugin -> verbs.ask(plugin.name(), verb, ""));
    done.run();
  }

  private QuietButton button(String words, Icon icon, Runnable pressed) {
    QuietButton made = new QuietButton(root, theme, pressed).text(words).icon(icon);
    made.setLayoutData(Boxes.middle());
    return made;
  }

  private void paint(GC gc, Rectangle area) {
    shown.ifPresent(detail -> {
      gc.setFont(theme.font(Face.TITLE));
      gc.setForeground(theme.color(Role.TEXT));
      String title = TextFit.shorten(gc, detail.line().name(), area.width - Theme.STEP);
      int y = (area.height - gc.textExtent("X").y) / 2;
      gc.drawText(title, Theme.STEP, y, true);
      int left = Theme.STEP + gc.textExtent(title).x + 2 * Theme.STEP;
      gc.setFont(theme.font(Face.BODY));
      gc.setForeground(theme.color(Role.DIM));
      String kind = TextFit.shorten(gc, detail.kind(), area.width - left);
      gc.drawText(kind, left, (area.height - gc.textExtent("X").y) / 2, true);
    });
  }
}
