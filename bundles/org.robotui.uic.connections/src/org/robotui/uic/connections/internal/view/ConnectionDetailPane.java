package org.robotui.uic.connections.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.TextLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.host.Match;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.CandidateChooser;
import org.robotui.uic.connections.internal.model.ConnectionLine;

/** All of the selected line: its reason in full, or the candidates of a port that must be decided. Display thread. */
final class ConnectionDetailPane {
  /** Takes a decision. */
  @FunctionalInterface
  interface Decided {
    void connect(String ruic, SourceId port, SourceId peer);
  }

  private final Theme theme;
  private final Decided decided;
  private final Composite root;
  private final StackLayout layout = new StackLayout();
  private final PaintedCanvas words;
  private final CandidateChooser chooser;
  private Optional<ConnectionLine> line = Optional.empty();

  ConnectionDetailPane(Composite parent, Theme theme, Decided decided, Runnable back) {
    this.theme = theme;
    this.decided = decided;
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setLayout(layout);
    words = new PaintedCanvas(root, SWT.NO_FOCUS, theme, Role.PANEL, this::paint);
    chooser = new CandidateChooser(root, theme, this::chosen);
    chooser.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        back.run();
      }
    });
    layout.topControl = words;
  }

  Control control() {
    return root;
  }

  void show(Optional<ConnectionLine> next) {
    if (next.equals(line)) {
      return;
    }
    line = next;
    Optional<Match> decision = next.flatMap(ConnectionLine::decision);
    decision.ifPresent(match -> chooser.ask(match.reason(), match.candidates()));
    Control top = decision.isPresent() ? chooser : words;
    if (layout.topControl != top) {
      layout.topControl = top;
      root.layout();
    }
    words.redraw();
  }

  /** Goes to the candidates, where there are any. */
  boolean focus() {
    return layout.topControl == chooser && chooser.forceFocus();
  }

  private void chosen(SourceId peer) {
    line.ifPresent(l -> l.decision().ifPresent(match -> decided.connect(l.ruic(), match.port(), peer)));
  }

  private void paint(GC gc, Rectangle area) {
    if (line.isEmpty()) {
      text(gc, area, Theme.EDGE, "Select a line to read all of it.", Face.BODY, Role.DIM);
      return;
    }
    ConnectionLine shown = line.get();
    String[] lines = shown.details().split("\n", 2);
    HealthDot.paint(gc, theme, shown.health(), area.x + Theme.EDGE + HealthDot.SIZE / 2, area.y + Theme.EDGE + 9);
    text(gc, area, Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP,
        shown.level() == 0 ? lines[0] : shown.ruic() + " \u203a " + lines[0],
        Face.BODY_STRONG, Role.TEXT);
    rest(gc, area, lines.length > 1 ? lines[1] : "");
  }

  private void text(GC gc, Rectangle area, int x, String words, Face face, Role role) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    gc.drawText(TextFit.shorten(gc, words, area.width - x - Theme.EDGE), area.x + x, area.y + Theme.EDGE, true);
  }

  private void rest(GC gc, Rectangle area, String words) {
    TextLayout text = new TextLayout(gc.getDevice());
    text.setFont(theme.font(Face.BODY));
    text.setText(words);
    text.setWidth(Math.max(1, area.width - 2 * Theme.EDGE));
    gc.setForeground(theme.color(Role.DIM));
    text.draw(gc, area.x + Theme.EDGE, area.y + Theme.EDGE + 22);
    text.dispose();
  }
}
