package org.robotui.uic.team.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.team.internal.model.TeamCommands;
import org.robotui.uic.team.internal.model.TeamLook;
import org.robotui.uic.team.internal.model.TeamModel;
import org.robotui.uic.team.internal.view.TeamSurface;

/** The view: the tick takes what came, the surface lists and commands. */
final class TeamUic extends SurfaceUic<TeamSurface> {
  private final TeamModel model;
  private final TeamCommands commands;
  private volatile TeamLook look = TeamLook.NONE;

  TeamUic(UicContext context, List<String> leftOut, String task) {
    model = new TeamModel(context, leftOut, task);
    commands = new TeamCommands(context);
  }

  @Override
  public boolean tick(long nowNanos) {
    TeamLook next = model.tick(nowNanos);
    boolean changed = !next.equals(look);
    look = next;
    if (changed) {
      surface().ifPresent(s -> s.prepare(next));
    }
    return changed;
  }

  @Override
  protected TeamSurface open(Composite parent, UiContext ui) {
    TeamSurface made = new TeamSurface(parent, ui, commands);
    made.prepare(look);
    return made;
  }

  @Override
  protected void refresh(TeamSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Open the UI of the robot"),
        new ViewKey("Ctrl+F, /", "Filter"),
        new ViewKey("Esc", "Cancel the question"));
  }
}
