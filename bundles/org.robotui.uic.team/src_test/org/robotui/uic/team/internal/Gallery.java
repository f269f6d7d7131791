package org.robotui.uic.team.internal;

import java.util.Random;
import java.util.Set;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.port.InputState;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 900, 520, busy(50));
    cell(906, 0, 690, 260, busy(10));
    cell(906, 266, 690, 254, busy(2));
    cell(0, 526, 460, 300, busy(10));
    cell(466, 526, 560, 300, new Squad(6));
    cell(1032, 526, 560, 300, new Squad(0));
    Squad stopped = busy(8);
    for (int i = 1; i <= 8; i++) {
      stopped.robot(i).stop(FakeAuthority.YOU);
    }
    cell(0, 832, 900, 270, stopped);
    Squad meant = busy(8);
    meant.context.ruic().selection().set(Set.of("r2", "r5", "r6"));
    cell(906, 832, 690, 270, meant);
  }

  private static Squad busy(int count) {
    Squad squad = new Squad(count);
    Random random = new Random(4);
    String[] tasks = {"patrolling", "going to 12.4 8.1", "arrived", "standing"};
    for (int i = 1; i <= count; i++) {
      int task = random.nextInt(4);
      squad.drives(i, random.nextDouble(30), random.nextDouble(20), task < 2 ? random.nextDouble(0.1, 0.6) : 0)
          .charged(i, random.nextDouble(0.05, 1)).does(i, task == 2 ? 3 : 1, tasks[task]);
    }
    if (count > 4) {
      squad.lose(2).is(4, new InputState.Stale(2.1, "the newest is older than usual"))
          .is(5, InputState.Stale.lost(20, "nobody publishes /r5/odom any more", 12));
      squad.robot(3).stop(FakeAuthority.ANNA);
      squad.does(6, 4, "gave up: the way is blocked");
    }
    return squad;
  }

  private void cell(int x, int y, int width, int height, Squad squad) {
    Composite part = window.cell(x, y, width, height);
    TeamUic uic = (TeamUic) new TeamType().create(squad.context, squad.context.settings().current());
    uic.tick(System.nanoTime());
    uic.tick(System.nanoTime());
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
  }
}
