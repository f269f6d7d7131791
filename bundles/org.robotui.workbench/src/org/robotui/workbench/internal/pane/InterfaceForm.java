package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.host.Host;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.SettingsForm;
import org.robotui.workbench.internal.model.ExchangeModel;

/** Which robot interface, of which framework, and its settings. Display thread only. */
final class InterfaceForm extends Composite {
  private static final int FIELD_HEIGHT = 28;
  private static final int GAP = 10;

  private final Theme theme;
  private final ExchangeModel model;
  private final ChoiceField which;
  private final ChoiceField type;
  private final SettingsForm settings;
  private final Runnable edited;

  InterfaceForm(Composite parent, Theme theme, Host host, ExchangeModel model, Runnable edited) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.model = model;
    this.edited = edited;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = Theme.EDGE;
    layout.marginHeight = GAP;
    layout.verticalSpacing = Theme.STEP;
    setLayout(layout);
    heading("INTERFACE");
    which = field("Which robot interface", this::chooseInterface);
    heading("FRAMEWORK");
    type = field("The framework", this::chooseType);
    heading("SETTINGS");
    settings = new SettingsForm(this, theme, host::wrong);
    settings.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    settings.onChange(this::typed);
    show();
  }

  /** Shows what is wanted. */
  void show() {
    which.show(name(model.wanted()));
    type.show(model.type().map(t -> t.descriptor().label()).orElse(model.wanted().type()));
    type.control().setToolTipText(model.type().map(t -> t.descriptor().help()).orElse(""));
    settings.show(model.schema(), model.values());
  }

  /** Whether everything that was typed can be tried. */
  boolean isFine() {
    return settings.problems().isEmpty();
  }

  private void typed() {
    model.values(settings.values());
    edited.run();
  }

  private void chooseInterface() {
    PopupMenu menu = new PopupMenu(which.control());
    model.interfaces()
        .forEach(i -> menu.radio(name(i), i.id().equals(model.wanted().id()), () -> take(() -> model.want(i))));
    menu.openBelow(which.control());
  }

  private void chooseType() {
    PopupMenu menu = new PopupMenu(type.control());
    for (Installed t : model.types()) {
      String id = t.descriptor().id();
      menu.radio(t.descriptor().label() + "  (" + id + ")", id.equals(model.wanted().type()),
          () -> take(() -> model.type(id)));
    }
    menu.openBelow(type.control());
  }

  private void take(Runnable change) {
    change.run();
    show();
    typed();
  }

  private static String name(InterfaceConfig i) {
    return i.id() + (i.title().isEmpty() ? "" : "  \u00b7  " + i.title()) + "  \u00b7  " + i.type();
  }

  private void heading(String words) {
    ShortenedLabel heading = new ShortenedLabel(this, theme, Face.SMALL_STRONG, Role.DIM, words);
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.verticalIndent = Theme.STEP;
    heading.setLayoutData(data);
  }

  private ChoiceField field(String name, Runnable opened) {
    ChoiceField field = new ChoiceField(this, theme, name, opened);
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.heightHint = FIELD_HEIGHT;
    field.control().setLayoutData(data);
    return field;
  }
}
