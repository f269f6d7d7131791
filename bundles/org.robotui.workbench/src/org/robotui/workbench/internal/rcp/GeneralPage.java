package org.robotui.workbench.internal.rcp;

import org.eclipse.jface.preference.PreferencePage;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchPreferencePage;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.pane.GeneralPane;

/** The first page of the preferences. */
public final class GeneralPage extends PreferencePage implements IWorkbenchPreferencePage {
  /** As in plugin.xml. */
  static final String ID = "org.robotui.workbench.preferences.general";

  private final WorkbenchSession session = WorkbenchServices.session();

  @Override
  public void init(IWorkbench platform) {
    noDefaultAndApplyButton();
  }

  @Override
  protected Control createContents(Composite parent) {
    Composite place = Trim.place(parent);
    new Rebuilt<>(place, session, (within, theme) -> new GeneralPane(within, theme, session.look().choice(),
        session.look()::change, session.state().folder()), pane -> {});
    place.setLayoutData(new GridData(GridData.FILL_BOTH));
    return place;
  }
}
