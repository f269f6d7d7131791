package org.robotui.ros;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;

/**
 * Inputs that decoders once stumbled over, or might: one folder a decoder, one small file an input, replayed in every
 * run. A fuzzer that finds another one says what to put there.
 */
public final class Corpus {

  private static final String PLACE = "src_test/org/robotui/ros/corpus";

  /** A decoder under test. */
  @FunctionalInterface
  public interface Decoder {

    /** Decodes, or refuses with what the decoder declares; answers whether it accepted. */
    boolean accepts(byte[] input);
  }

  private Corpus() {}

  /** The inputs for one decoder. */
  public static List<Path> of(String decoder) throws IOException {
    try (Stream<Path> files = Files.list(folder().resolve(decoder))) {
      return files.sorted().toList();
    }
  }

  private static Path folder() {
    Stream<Path> places =
        Stream.concat(Optional.ofNullable(System.getenv("ROBOTUI_ROOT")).stream().map(Path::of), Stream.of(Path.of("")))
            .flatMap(root -> Stream.of(root.resolve("bundles/org.robotui.ros").resolve(PLACE), root.resolve(PLACE)));
    return places.filter(Files::isDirectory).findFirst()
        .orElseThrow(() -> new AssertionError("the corpus is not found: set ROBOTUI_ROOT to the repository"));
  }

  /** Tries one input; what the decoder does not declare fails the test with the input, ready to be kept. */
  public static boolean accepts(String name, Decoder decoder, byte[] input) {
    try {
      return decoder.accepts(input);
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      return Assertions
          .fail("put this into " + PLACE + "/" + name + " (base64): " + Base64.getEncoder().encodeToString(input), e);
    }
  }
}
