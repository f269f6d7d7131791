package org.robotui.uic.scene3d.internal.view;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.FileDialog;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.ui.Health;
import org.robotui.ui.control.SaveDialog;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.waypoint.Route;
import org.robotui.uic.scene3d.internal.waypoint.RouteText;

/**
 * Loads and saves waypoints: files are read and written in the background, and what became of it is said in the scene.
 */
final class WaypointFiles {
  private static final String YAML = "*.yaml";
  private static final String CSV = "*.csv";

  private final SceneSurface scene;
  private final SceneParts parts;

  WaypointFiles(SceneSurface scene, SceneParts parts) {
    this.scene = scene;
    this.parts = parts;
  }

  /** Asks which file, and takes its waypoints in place of those that are there. Display thread. */
  void load() {
    FileDialog dialog = new FileDialog(scene.canvas().getShell(), SWT.OPEN);
    dialog.setText("Load waypoints");
    dialog.setFilterExtensions(new String[]{"*.yaml;*.yml;*.csv", "*"});
    dialog.setFilterNames(new String[]{"Waypoints (*.yaml, *.csv)", "All files"});
    Optional.ofNullable(dialog.open()).map(Path::of).ifPresent(this::load);
  }

  /** Asks where to, and saves. Display thread. */
  void save() {
    SaveDialog.ask(scene.canvas(), "Save the waypoints", "waypoints.yaml", YAML, CSV).ifPresent(this::save);
  }

  /** Takes the waypoints of a file with a later tick. */
  void load(Path file) {
    parts.background().execute(() -> {
      switch (read(file)) {
        case RouteText.Outcome.Read read -> parts.model().soon(() -> scene.say(parts.waypoints().take(read)));
        case RouteText.Outcome.Unreadable not -> scene
            .say(new CommandNotice(Health.BAD, "Not loaded, " + file.getFileName() + ": " + not.why()));
      }
    });
  }

  /** Writes the waypoints as they are now. */
  void save(Path file) {
    Route route = parts.waypoints().route();
    parts.background().execute(() -> scene.say(write(file, route)));
  }

  private static RouteText.Outcome read(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(RouteText.MOST + 1);
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      return RouteText.read(file.getFileName().toString(), text);
    } catch (CharacterCodingException e) {
      return new RouteText.Outcome.Unreadable("it is no text in UTF-8");
    } catch (NoSuchFileException e) {
      return new RouteText.Outcome.Unreadable("there is no such file");
    } catch (IOException e) {
      return new RouteText.Outcome.Unreadable(e.getMessage());
    }
  }

  private static CommandNotice write(Path file, Route route) {
    try {
      AtomicFile.write(file, RouteText.write(file.getFileName().toString(), route));
      return new CommandNotice(Health.OK, "Saved " + route.poses().size()
          + (route.poses().size() == 1 ? " waypoint to " : " waypoints to ") + file.getFileName());
    } catch (IOException e) {
      return new CommandNotice(Health.BAD, "Not saved, " + file.getFileName() + ": " + WriteFailure.reason(e));
    }
  }
}
