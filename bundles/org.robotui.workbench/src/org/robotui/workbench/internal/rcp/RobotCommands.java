package org.robotui.workbench.internal.rcp;

import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.commands.ExecutionException;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.handlers.HandlerUtil;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;

/** Our commands, so that menus, keys and the search find them. */
public final class RobotCommands extends AbstractHandler {
  private static final String PREFIX = "org.robotui.workbench.command.";
  private static final String THEME = "org.robotui.workbench.theme";
  private static final String NUMBER = "org.robotui.workbench.perspective";

  @Override
  public Object execute(ExecutionEvent event) throws ExecutionException {
    IWorkbenchWindow window = HandlerUtil.getActiveWorkbenchWindowChecked(event);
    WorkbenchSession session = WorkbenchServices.session();
    WindowActions actions = new WindowActions(session, window);
    switch (event.getCommand().getId().substring(PREFIX.length())) {
      case "search" -> actions.search();
      case "keys" -> actions.shortcuts();
      case "new" -> actions.create();
      case "open" -> actions.open();
      case "open.recording" -> new FileChoice(session, window).choose();
      case "reload" -> actions.reload();
      case "stop" -> actions.stop();
      case "release" -> actions.release();
      case "stop.robot" -> session.stop(actions.authorities());
      case "release.robot" -> session.release(actions.authorities());
      case "lease" -> actions.lease();
      case "unselect" -> actions.withSelected(actions::unselect);
      case "restart" -> actions.withSelected(actions::restart);
      case "remove" -> actions.withSelected(actions::remove);
      case "connections" -> actions.withSelected(actions::connections);
      case "exchange" -> actions.withSelected(actions::exchange);
      case "reuse" -> actions.reuse();
      case "software" -> actions.software();
      case "welcome" -> new WelcomeActions(session, window, actions).dialog();
      case "about" -> new AboutAction(session, window).open();
      case "support" -> new SupportSaving(session, window.getShell()).choose();
      case "view.add" -> actions.addView();
      case "view.close" -> actions.layout().ifPresent(LayoutActions::close);
      case "view.maximize" -> actions.layout().ifPresent(layout -> layout.surface().maximize());
      case "layout.undo" -> actions.layout().ifPresent(layout -> layout.surface().docking().undo());
      case "layout.redo" -> actions.layout().ifPresent(layout -> layout.surface().docking().redo());
      case "layout.reset" -> actions.layout().ifPresent(layout -> layout.surface().docking().reset());
      case "operator" -> actions.operate();
      case "perspective" -> actions.perspective(Integer.parseInt(event.getParameter(NUMBER)));
      case "theme" -> session.look().change(event.getParameter(THEME));
      default -> throw new ExecutionException("no such command: " + event.getCommand().getId());
    }
    return null; // as the platform asks of every handler
  }
}
