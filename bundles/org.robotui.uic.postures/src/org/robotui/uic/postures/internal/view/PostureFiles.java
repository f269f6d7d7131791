package org.robotui.uic.postures.internal.view;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.FileDialog;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.ui.Health;
import org.robotui.ui.control.SaveDialog;
import org.robotui.uic.postures.internal.model.PostureSequence;
import org.robotui.uic.postures.internal.model.PostureText;
import org.robotui.uic.postures.internal.model.PosturesModel;

/** Opens and saves postures: files are read and written in the background, and what became of it is said below them. */
public final class PostureFiles {
  private static final String YAML = "*.yaml";

  private final Composite root;
  private final PosturesModel model;
  private final Consumer<Runnable> background;
  private final Runnable again;

  PostureFiles(Composite root, PosturesModel model, Consumer<Runnable> background, Runnable again) {
    this.root = root;
    this.model = model;
    this.background = background;
    this.again = again;
  }

  /** Asks which file, and takes its postures in place of those that are there. Display thread. */
  public void open() {
    FileDialog dialog = new FileDialog(root.getShell(), SWT.OPEN);
    dialog.setText("Open postures");
    dialog.setFilterExtensions(new String[]{"*.yaml;*.yml", "*"});
    dialog.setFilterNames(new String[]{"Postures (*.yaml)", "All files"});
    Optional.ofNullable(dialog.open()).map(Path::of).ifPresent(this::open);
  }

  /** Asks where to, and saves. Display thread. */
  public void save() {
    SaveDialog.ask(root, "Save the postures", "postures.yaml", YAML).ifPresent(this::save);
  }

  /** Takes the postures of a file. */
  void open(Path file) {
    background.accept(() -> {
      model.take(file.getFileName().toString(), read(file));
      show();
    });
  }

  /** Writes the postures as they are now. */
  void save(Path file) {
    PostureSequence sequence = model.sequence();
    background.accept(() -> {
      write(file, sequence);
      show();
    });
  }

  private void show() {
    if (!root.isDisposed()) {
      root.getDisplay().asyncExec(again);
    }
  }

  private static PostureText.Content read(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(PostureText.MOST + 1);
      return PostureText.read(StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString());
    } catch (CharacterCodingException e) {
      return new PostureText.Content.Unreadable("it is no text in UTF-8");
    } catch (NoSuchFileException e) {
      return new PostureText.Content.Unreadable("there is no such file");
    } catch (IOException e) {
      return new PostureText.Content.Unreadable(e.getMessage());
    }
  }

  private void write(Path file, PostureSequence sequence) {
    try {
      AtomicFile.write(file, PostureText.write(sequence));
      int count = sequence.postures().size();
      model.say(Health.OK, "Saved " + (count == 1 ? "1 posture" : count + " postures") + " to " + file.getFileName());
    } catch (IOException e) {
      model.say(Health.BAD, "Not saved, " + file.getFileName() + ": " + WriteFailure.reason(e));
    }
  }
}
