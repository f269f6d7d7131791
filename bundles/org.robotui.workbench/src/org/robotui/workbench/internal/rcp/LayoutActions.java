package org.robotui.workbench.internal.rcp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.NamedFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.Arranging;
import org.robotui.api.host.Arranging.PerspectiveImport;
import org.robotui.api.host.Arranging.ViewChoice;
import org.robotui.api.host.ViewFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.SaveDialog;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.dock.RuicSurface;
import org.robotui.workbench.internal.dock.ViewEntry;
import org.robotui.workbench.internal.dock.ViewPictures;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.pane.SearchPane;

/**
 * What menus and keys do to the arrangement of the views of one window. Display thread only.
 *
 * @param shell of the window
 * @param theme colours and fonts
 * @param surface its views
 */
record LayoutActions(Shell shell, Theme theme, RuicSurface surface) {
  private static final String USELESS = "No data";
  private static final String PATTERN = "*.yaml";
  private static final long MOST_BYTES = 1 << 20;

  /** Has the user choose among the views that are closed and the types of all others. */
  void addView() {
    SearchPane.openList(shell, theme, "Search views to add", choices());
  }

  /** Closed views first, then types that fit this robot, then the others with the reason. */
  List<SearchEntry> choices() {
    Arranging arranging = surface.docking().arranging();
    Optional<String> beside = surface.lastFocused().map(ViewEntry::id);
    List<SearchEntry> entries = new ArrayList<>();
    arranging.views().stream().filter(view -> !view.open()).forEach(view -> entries.add(
        new SearchEntry("Closed", view.title(), "", () -> show(view))));
    arranging.types().forEach(fit -> entries.add(new SearchEntry(group(fit), label(fit), "",
        () -> surface.reveal(surface.docking().add(fit.type(), beside)))));
    return entries;
  }

  /** Whether a choice is a view that would show something, or was open before. */
  static boolean isOfUse(SearchEntry choice) {
    return !choice.group().equals(USELESS);
  }

  private static String group(ViewFit fit) {
    return switch (fit.fit()) {
      case CONNECTED -> "Fits";
      case AMBIGUOUS -> "Asks which";
      case PENDING -> "Waits";
      case MISSING -> USELESS;
    };
  }

  private static String label(ViewFit fit) {
    return fit.label() + " \u00b7 " + (fit.fits() ? fit.help() : fit.reason());
  }

  /** Brings a view to the front; one that is closed is opened. */
  void show(ViewChoice view) {
    if (!view.open()) {
      surface.docking().open(view.id());
    }
    surface.reveal(view.id());
  }

  /** Closes the view that has, or had, the keys. */
  void close() {
    surface.lastFocused().map(ViewEntry::id).ifPresent(surface.docking()::close);
  }

  /** Has what the view shows of the recordings saved that has, or had, the keys. */
  void savePictures() {
    surface.lastSeen().ifPresent(view -> WorkbenchServices.session().pictures().ask(surface, theme,
        surface.ruic().title(view.id()), new ViewPictures(surface, view)));
  }

  /** Gives the present arrangement a name. */
  void keep() {
    Arranging arranging = surface.docking().arranging();
    NameDialog.ask(surface, "Name of the perspective", arranging.perspective().orElse("")).ifPresent(name -> {
      boolean replaces = arranging.perspectives().containsKey(name);
      if (!replaces || MessageDialog.openQuestion(shell, "Replace perspective",
          "There is a perspective '" + name + "'. Replace it by what is seen now?")) {
        keep(arranging, name);
      }
    });
  }

  private void keep(Arranging arranging, String name) {
    try {
      arranging.keep(name);
    } catch (IllegalArgumentException e) {
      MessageDialog.openError(shell, "Perspective", "It was not kept: " + e.getMessage() + ".");
    }
  }

  /** Forgets a perspective. */
  void forget(String name) {
    if (MessageDialog.openQuestion(shell, "Delete perspective", "Delete the perspective '" + name + "'?")) {
      surface.docking().arranging().forget(name);
    }
  }

  /** Gives a perspective another name. */
  void rename(String name) {
    Arranging arranging = surface.docking().arranging();
    NameDialog.ask(surface, "New name of the perspective", name).filter(next -> !next.equals(name)).ifPresent(next -> {
      try {
        arranging.rename(name, next);
      } catch (IllegalArgumentException e) {
        MessageDialog.openError(shell, "Perspective", "It was not renamed: " + e.getMessage() + ".");
      }
    });
  }

  /** Writes a perspective into a file. */
  void export(String name) {
    Optional<String> text = surface.docking().arranging().export(name);
    Optional<Path> file = text.flatMap(t -> SaveDialog.ask(surface, "Export perspective",
        name.replaceAll("[^\\w-]+", "-") + ".perspective.yaml", PATTERN));
    file.ifPresent(f -> {
      try {
        AtomicFile.write(f, text.get());
      } catch (IOException e) {
        MessageDialog.openError(shell, "Export perspective", f + " could not be written: " + WriteFailure.reason(e));
      }
    });
  }

  /** Reads a perspective from a file, keeps it and shows it. */
  void take() {
    FileDialog dialog = new FileDialog(shell, SWT.OPEN);
    dialog.setText("Import perspective");
    dialog.setFilterExtensions(new String[]{PATTERN, "*"});
    Optional.ofNullable(dialog.open()).map(Path::of).ifPresent(this::take);
  }

  private void take(Path file) {
    try {
      take(file, surface.docking().arranging().take(NamedFile.text(file, MOST_BYTES)));
    } catch (IOException e) {
      MessageDialog.openError(shell, "Import perspective", file + " could not be read: " + e.getMessage());
    }
  }

  private void take(Path file, PerspectiveImport outcome) {
    switch (outcome) {
      case PerspectiveImport.Refused refused -> MessageDialog.openError(shell, "Import perspective",
          file + ": " + refused.reason());
      case PerspectiveImport.Kept kept -> {
        surface.docking().choose(kept.name());
        if (!kept.missing().isEmpty()) {
          MessageDialog.openInformation(shell, "Import perspective", "'" + kept.name()
              + "' is here, without what this robot UI cannot have:\n\n" + String.join("\n", kept.missing()));
        }
      }
    }
  }
}
