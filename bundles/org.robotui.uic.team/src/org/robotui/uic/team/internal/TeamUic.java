package org.robotui.uic.team.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.team.internal.model.TeamCommands;
import org.robotui.uic.team.internal.model.TeamLook;
import org.robotui.uic.team.internal.model.TeamModel;
import org.robotui.uic.team.internal.view.TeamSurface;

/** The view: the tick takes what came, the surface lists and commands. */
final class TeamUic implements SwtUic {
  private final TeamModel model;
  private final TeamCommands commands;
  private volatile TeamLook look = TeamLook.NONE;
  private volatile Optional<TeamSurface> surface = Optional.empty();

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
      surface.ifPresent(s -> s.prepare(next));
    }
    return changed;
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    TeamSurface made = new TeamSurface(parent, ui, commands);
    made.prepare(look);
    made.refresh();
    surface = Optional.of(made);
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Open the UI of the robot"),
        new ViewKey("Ctrl+F, /", "Filter"),
        new ViewKey("Esc", "Cancel the question"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(TeamSurface::refresh);
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }
}
