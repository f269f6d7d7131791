package org.robotui.workbench.internal.rcp;

import java.util.LinkedHashMap;
import java.util.Map;
import org.eclipse.core.commands.common.CommandException;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.SWT;
import org.eclipse.swt.program.Program;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.handlers.IHandlerService;
import org.osgi.framework.FrameworkUtil;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.pane.AboutDialog;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Says which RobotUI this is. Display thread only. */
final class AboutAction implements AboutDialog.Links {
  private static final Logger LOG = LoggerFactory.getLogger(AboutAction.class);
  private static final String INSTALLATION = "org.eclipse.ui.help.installationDialog";

  private final WorkbenchSession session;
  private final IWorkbenchWindow window;
  private final Documentation documentation = new Documentation(HelpItems.installation(), Program::launch);

  AboutAction(WorkbenchSession session, IWorkbenchWindow window) {
    this.session = session;
    this.window = window;
  }

  void open() {
    new AboutDialog(window.getShell(), session.look().theme(), facts(), this).open();
  }

  private Map<String, String> facts() {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("Version", FrameworkUtil.getBundle(getClass()).getVersion().toString());
    facts.put("Java", System.getProperty("java.version") + " (" + System.getProperty("java.vendor") + ") in "
        + System.getProperty("java.home"));
    facts.put("System", System.getProperty("os.name") + " " + System.getProperty("os.version") + ", "
        + System.getProperty("os.arch") + ", " + Runtime.getRuntime().availableProcessors() + " processors");
    facts.put("Window", "SWT " + SWT.getVersion() + " on " + SWT.getPlatform() + ", " + session.look().theme().id()
        + " theme");
    facts.put("Installed", HelpItems.installation().toString());
    facts.put("Kept in", session.state().folder().toString());
    return facts;
  }

  @Override
  public void documentation() {
    tell(documentation.index().getFileName().toString());
  }

  @Override
  public void licences() {
    tell("THIRD-PARTY.html");
  }

  private void tell(String page) {
    documentation.open(documentation.index().resolveSibling(page))
        .ifPresent(why -> MessageDialog.openInformation(window.getShell(), "Documentation", why));
  }

  @Override
  public void installation() {
    try {
      window.getService(IHandlerService.class).executeCommand(INSTALLATION, null);
    } catch (CommandException e) {
      LOG.warn("What is installed cannot be shown", e);
      MessageDialog.openInformation(window.getShell(), "Installed Software", "It cannot be shown: " + e.getMessage());
    }
  }
}
