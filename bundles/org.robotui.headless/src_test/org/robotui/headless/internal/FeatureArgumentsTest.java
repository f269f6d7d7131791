package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.headless.internal.FeatureArguments.Verb;

final class FeatureArgumentsTest {
  private static List<String> words(String text) {
    return Arrays.asList(text.split(" "));
  }

  @Test
  void aSiteAndFeaturesAreRead() throws Exception {
    assertEquals(new FeatureArguments(Verb.INSTALL, Optional.of(URI.create("http://localhost/site")),
        List.of("a", "b"), true),
        FeatureArguments.parse(words("-features install -site http://localhost/site a -unsigned b")));
    assertEquals(Verb.UPDATE, FeatureArguments.parse(words("-features update")).verb());
  }

  @ParameterizedTest
  @CsvSource({"-features,needs a value", "-features fly,not 'fly'", "-features install,needs -site URI",
      "-features install -site,needs a value", "-features install -site there,needs an address",
      "-features install -site http://a|b,no address", "-features remove,needs a feature"})
  void whatIsMissingIsSaid(String text, String sentence) {
    String message =
        assertThrows(Arguments.Wrong.class, () -> FeatureArguments.parse(words(text))).getMessage();

    assertTrue(message.contains(sentence), message);
  }
}
