package org.robotui.workbench.internal.rcp;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.dialogs.PreferencesUtil;
import org.robotui.api.command.Authority;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Subject;
import org.robotui.install.FeatureInstaller;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.ExchangeModel;
import org.robotui.workbench.internal.model.NewRobotModel;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.model.SoftwareModel;
import org.robotui.workbench.internal.model.WindowModel;
import org.robotui.workbench.internal.pane.ConnectionsDialog;
import org.robotui.workbench.internal.pane.ExchangeDialog;
import org.robotui.workbench.internal.pane.LeaseMenu;
import org.robotui.workbench.internal.pane.Navigator;
import org.robotui.workbench.internal.pane.NewRobotDialog;
import org.robotui.workbench.internal.pane.ReuseDialog;
import org.robotui.workbench.internal.dock.RobotArea;
import org.robotui.workbench.internal.pane.SearchPane;
import org.robotui.workbench.internal.pane.SoftwareDialog;
import org.robotui.workbench.internal.pane.TopBar;

/** What the panes and commands of one window do. Display thread only. */
final class WindowActions implements TopBar.Actions, Navigator.Actions, RobotArea.Actions {
  private static final String FOLDER = "folder";

  private final WorkbenchSession session;
  private final IWorkbenchWindow window;

  WindowActions(WorkbenchSession session, IWorkbenchWindow window) {
    this.session = session;
    this.window = window;
  }

  @Override
  public void menu(String id, Control below) {
    new PopupMenu(window, id).show(below);
  }

  @Override
  public void search() {
    front();
    SearchPane.open(window.getShell(), session.look().theme(), new SearchEntries(session, window).all());
  }

  /** Shows all shortcuts, those of the view that has the focus first. */
  void shortcuts() {
    front();
    SearchPane.openShortcuts(window.getShell(), session.look().theme(), new SearchEntries(session, window).shortcuts());
  }

  /** The keys may be with a view in a window of its own. */
  private void front() {
    window.getShell().forceActive();
  }

  /** Asks what is to be done with something of a robot: which view shows it, and how. */
  void choose(Ruic ruic, Subject subject) {
    List<SearchEntry> choices = ruic.showChoices(subject).stream().filter(ShowChoice::possible)
        .map(choice -> new SearchEntry(choice.title(), choice.showing().label(), "", () -> ruic.show(choice, subject)))
        .toList();
    SearchPane.openList(window.getShell(), session.look().theme(), "What to do with it", choices);
  }

  @Override
  public void record(Control below) {
    WorkbenchServices.recorder().ifPresent(recorder -> new RecordMenu(session, recorder, selected()).openBelow(below));
  }

  @Override
  public void lease() {
    List<Authority> all = selected().map(Ruic::authorities).orElse(List.of());
    if (all.size() > 1) {
      new LeaseMenu(window.getShell(), session.user(), this::lease).open(all);
    } else {
      all.forEach(this::lease);
    }
  }

  @Override
  public void stop() {
    session.stop();
  }

  @Override
  public void release() {
    session.release();
  }

  @Override
  public void open() {
    FileDialog dialog = new FileDialog(window.getShell(), SWT.OPEN);
    dialog.setText("Open configuration");
    dialog.setFilterExtensions(new String[]{"*.yaml;*.yml", "*"});
    dialog.setFilterNames(new String[]{"Configurations (*.yaml)", "All files"});
    session.state().get(FOLDER).ifPresent(dialog::setFilterPath);
    Optional.ofNullable(dialog.open()).map(Path::of).ifPresent(file -> {
      session.state().put(FOLDER, file.getParent().toString());
      session.configurations().load(file);
    });
  }

  @Override
  public void create() {
    List<Path> files = session.configurations().files();
    Path near = files.stream().findFirst().map(Path::toAbsolutePath)
        .orElseGet(
            () -> Path.of(session.state().get(FOLDER).orElse(System.getProperty("user.home"))).resolve("robot.yaml"));
    WindowModel shown = model();
    new NewRobotDialog(window.getShell(), session.look().theme(), session.host(),
        new NewRobotModel(session.host(), near), files,
        session.configurations().background(), (file, name) -> {
          session.showWhenThere(shown, name);
          session.configurations()
              .load(files.stream().filter(f -> f.toAbsolutePath().normalize().equals(file)).findFirst().orElse(file));
        }).open();
  }

  @Override
  public void select(String ruic) {
    session.ruic(ruic).ifPresent(r -> session.windows().elsewhere(model(), r)
        .ifPresentOrElse(other -> selectFrom(other, r), () -> session.windows().select(model(), r)));
    session.refresh();
  }

  /** The other window would show nothing then, so the user is asked. */
  private void selectFrom(WindowModel other, Ruic ruic) {
    String question = ruic.name()
        + " is shown in another window. A robot is shown in one window at a time; moved here, it leaves the other one empty.";
    int answer = MessageDialog.open(MessageDialog.QUESTION, window.getShell(), ruic.name() + " is shown elsewhere",
        question, SWT.NONE,
        "Go to That Window", "Move It Here", "Cancel");
    if (answer == 0) {
      other.front();
    } else if (answer == 1) {
      session.windows().select(model(), ruic);
    }
  }

  @Override
  public void unselect(String ruic) {
    session.windows().unselect(model());
    session.refresh();
  }

  @Override
  public void restart(String ruic) {
    session.ruic(ruic).ifPresent(this::restart);
  }

  @Override
  public void restart(Ruic ruic) {
    ruic.restart();
  }

  @Override
  public void remove(String ruic) {
    session.ruic(ruic).ifPresent(Ruic::remove);
  }

  @Override
  public Optional<String> closing(String ruic) {
    return FileChoice.closing(session, ruic);
  }

  @Override
  public void connections(String ruic) {
    session.ruic(ruic).ifPresent(r -> new ConnectionsDialog(window.getShell(), session.look().theme(), r).open());
  }

  @Override
  public void portMenu(Control over, String ruic, SourceId port) {
    session.ruic(ruic).ifPresent(r -> new SubjectMenu(r, session.look().theme(), session.configurations().background())
        .open(over, Subject.Stream.of(port)));
  }

  @Override
  public void exchange(String ruic) {
    dialog(ruic).ifPresent(ExchangeDialog::open);
  }

  @Override
  public void settings(String ruic) {
    PreferencesUtil.createPreferenceDialogOn(window.getShell(), RobotsPage.ID, null, ruic).open();
  }

  /** Somebody has written another robot interface into the file. */
  void exchange(String ruic, InterfaceConfig wanted) {
    dialog(ruic).ifPresent(d -> d.open(wanted));
  }

  private Optional<ExchangeDialog> dialog(String name) {
    return session.ruic(name).filter(r -> !r.interfaces().isEmpty())
        .map(r -> session.exchanges().computeIfAbsent(name,
            n -> new ExchangeDialog(window.getShell(), session.look().theme(),
                session.host(), new ExchangeModel(session.host(), r), session.alerts()::pass)));
  }

  /** Shows which bundles are used by which robot UIs. */
  void reuse() {
    new ReuseDialog(window.getShell(), session.look().theme(), session.host().reuse()).open();
  }

  /** Installs, updates and removes features. */
  void software() {
    Shell shell = window.getShell();
    Optional<FeatureInstaller> installer = WorkbenchServices.installer();
    if (installer.isEmpty()) {
      MessageDialog.openInformation(shell, "Install Software",
          "The installer has not started, so that nothing can be installed.");
      return;
    }
    SoftwareModel model = new SoftwareModel(installer.get(),
        task -> Thread.ofPlatform().daemon().name("robotui-software").start(task), task -> onDisplay(shell, task),
        names -> acceptsUnsigned(shell, names));
    new SoftwareDialog(shell, session.look().theme(), model).open();
  }

  /** The window may have gone before what was begun there has ended. */
  private static void onDisplay(Shell shell, Runnable task) {
    if (!shell.isDisposed()) {
      shell.getDisplay().asyncExec(task);
    }
  }

  /** Asked by the installer, which waits for the answer; where nobody can be asked, nobody has agreed. */
  private static boolean acceptsUnsigned(Shell shell, List<String> names) {
    AtomicBoolean accepted = new AtomicBoolean();
    if (!shell.isDisposed()) {
      shell.getDisplay().syncExec(() -> accepted.set(MessageDialog.open(MessageDialog.WARNING, shell, "Not signed",
          "Nobody has signed " + String.join(", ", names)
              + ". What it holds can do all that you can do on this machine.",
          SWT.NONE, "Install", "Cancel") == 0));
    }
    return accepted.get();
  }

  @Override
  public void reload() {
    session.configurations().reload();
  }

  @Override
  public void closeProblems() {
    session.configurations().forget();
  }

  @Override
  public void addView() {
    layout().ifPresent(LayoutActions::addView);
  }

  @Override
  public Optional<Control> welcome(Composite parent, Theme theme) {
    WelcomeActions welcome = new WelcomeActions(session, window, this);
    return welcome.isWanted() ? Optional.of(welcome.pane(parent, theme)) : Optional.empty();
  }

  /** The arrangement of the views that the window shows; none while it shows no views. */
  Optional<LayoutActions> layout() {
    return RobotPart.in(window).flatMap(part -> part.area().surface())
        .map(surface -> new LayoutActions(window.getShell(), session.look().theme(), surface));
  }

  /** The same, for what the platform makes for a window. */
  static Optional<LayoutActions> layoutOf(IWorkbenchWindow window) {
    return new WindowActions(WorkbenchServices.session(), window).layout();
  }

  /** Gives the window to an operator, or to everybody again. */
  void operate() {
    boolean now = !model().isOperated();
    String key = session.keys().text("operator");
    if (now && key.isEmpty()) {
      session.alerts()
          .pass("Operator mode needs a key that leaves it again: Window > Preferences > Keys gives it one.");
      session.refresh();
      return;
    }
    model().operate(now);
    Trim.navigator(window, !now);
    window.getShell().setFullScreen(now);
    // What had the focus may be hidden now; without any, no key would be heard, not even that which leaves this mode.
    RobotPart.in(window).ifPresent(part -> {
      window.getActivePage().activate(part);
      part.setFocus();
    });
    if (now) {
      session.alerts().pass("Operator mode: views stay where they lie. " + key + " leaves it.");
    }
    session.refresh();
  }

  /** Arranges the views as one of the perspectives has them, by its number from 1. */
  void perspective(int number) {
    layout().map(l -> l.surface().docking()).ifPresent(docking -> docking.arranging().perspectives().keySet().stream()
        .skip(number - 1L).findFirst().ifPresent(docking::choose));
  }

  /** Does something with the selected RUIC. */
  void withSelected(Consumer<String> action) {
    selected().map(Ruic::name).ifPresent(action);
  }

  /** Who may command the robots of this window. */
  List<Authority> authorities() {
    return selected().map(Ruic::authorities).orElse(List.of());
  }

  private WindowModel model() {
    return session.model(window);
  }

  private Optional<Ruic> selected() {
    return model().selected();
  }

  private void lease(Authority authority) {
    if (authority.holder().filter(session.user()::equals).isPresent()) {
      authority.giveBack(session.user());
    } else if (authority.take(session.user(), false) instanceof Authority.LeaseOutcome.HeldBy held) {
      String question = held.holder().label() + " controls " + authority.robot() + ". Take over?";
      if (MessageDialog.openConfirm(window.getShell(), "Take over", question)) {
        authority.take(session.user(), true);
      }
    }
    session.refresh();
  }
}
