package org.robotui.workbench.internal.rcp;

import org.eclipse.core.commands.ParameterizedCommand;
import org.eclipse.core.commands.common.CommandException;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.handlers.IHandlerService;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs commands of the platform in a window. */
final class WorkbenchCommands {
  private static final Logger LOG = LoggerFactory.getLogger(WorkbenchCommands.class);

  private final IWorkbenchWindow window;

  WorkbenchCommands(IWorkbenchWindow window) {
    this.window = window;
  }

  void run(ParameterizedCommand command) {
    try {
      window.getService(IHandlerService.class).executeCommand(command, null);
    } catch (CommandException e) {
      LOG.warn("the command {} cannot be run now", command.getId(), e);
    }
  }

  void run(String id) {
    try {
      window.getService(IHandlerService.class).executeCommand(id, null);
    } catch (CommandException e) {
      LOG.warn("the command {} cannot be run now", id, e);
    }
  }
}
