package org.robotui.uic.map.internal.view;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.uic.map.internal.model.Team;

/**
 * Which colour is which robot's, top right, where there are a few. Where there are many, each has its name beside it.
 * Display thread.
 */
final class Legend {
  private static final int MOST = 8;
  private static final int ROW = 20;
  private static final int DISC = 10;

  private final Theme theme;
  private final StateView states;
  private final Team team;

  Legend(Theme theme, Team team) {
    this.theme = theme;
    this.states = new StateView(theme);
    this.team = team;
  }

  void paint(GC gc, Rectangle area, List<SeenRobot> robots) {
    if (!team.isSeveral() || robots.size() < 2 || robots.size() > MOST) {
      return;
    }
    gc.setFont(theme.font(Face.SMALL));
    int widest = robots.stream().mapToInt(r -> gc.textExtent(r.name()).x).max().orElse(0);
    int width = widest + DISC + 2 * Theme.STEP + 2 * Theme.EDGE;
    Rectangle box =
        new Rectangle(area.width - width - Theme.EDGE, Theme.EDGE, width, robots.size() * ROW + 2 * Theme.STEP);
    states.pill(gc, box);
    for (int i = 0; i < robots.size(); i++) {
      String name = robots.get(i).name();
      int middle = box.y + Theme.STEP + i * ROW + ROW / 2;
      gc.setAntialias(SWT.ON);
      gc.setBackground(theme.traces().get(team.number(name) % theme.traces().size()));
      gc.fillOval(box.x + Theme.EDGE, middle - DISC / 2, DISC, DISC);
      gc.setForeground(theme.color(Role.TEXT));
      gc.drawText(name, box.x + Theme.EDGE + DISC + 2 * Theme.STEP, middle - gc.textExtent(name).y / 2, true);
    }
  }
}
