package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import java.net.MalformedURLException;
import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;

class OsgiBundleNamesTest {
  private final List<Bundle> bundles = new ArrayList<>();
  private final List<String> looked = new ArrayList<>();
  private final OsgiBundleNames names = new OsgiBundleNames(
      fake(BundleContext.class, Map.of("getBundles", any -> bundles.toArray(Bundle[]::new))));

  /** What a faked method does with its first argument. */
  @FunctionalInterface
  private interface Answer {
    Object to(String argument);
  }

  private static <T> T fake(Class<T> type, Map<String, Answer> answers) {
    return type.cast(Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[]{type}, (self, method,
        arguments) -> answers.get(method.getName()).to(arguments == null ? "" : String.valueOf(arguments[0]))));
  }

  private void install(long id, String name, String file) {
    bundles
        .add(fake(Bundle.class, Map.of("getBundleId", any -> id, "getSymbolicName", any -> name, "getEntry", entry -> {
          looked.add(entry);
          return entry.equals(file) ? url() : null;
        })));
  }

  private static Object url() {
    try {
      return URI.create("file:/somewhere").toURL();
    } catch (MalformedURLException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void theBundleWithTheLongestNameOfThePackagesAboveIsIt() {
    install(1, "org.robotui.uic", "");
    install(2, "org.robotui.uic.map", "");
    assertEquals(Optional.of("org.robotui.uic.map"), names.bundleOf("org.robotui.uic.map.internal.MapView"));
    assertEquals(List.of(), looked);
  }

  @Test
  void aClassIsLookedForInTheFilesOnce() {
    install(1, "junit-jupiter-api", "org/junit/Assert.class");
    assertEquals(Optional.of("junit-jupiter-api"), names.bundleOf("org.junit.Assert"));
    assertEquals(Optional.of("junit-jupiter-api"), names.bundleOf("org.junit.Assert"));
    assertEquals(List.of("org/junit/Assert.class"), looked);
  }

  @Test
  void aClassOfNoBundleIsFoundOnceItsBundleIsInstalled() {
    install(1, "junit-jupiter-api", "");
    assertEquals(Optional.empty(), names.bundleOf("com.example.View"));
    install(2, "com.example", "");
    assertEquals(Optional.of("com.example"), names.bundleOf("com.example.View"));
    bundles.removeLast();
    assertEquals(Optional.empty(), names.bundleOf("com.example.View"));
  }

  @Test
  void classesOfJavaAreLookedForNowhere() {
    install(1, "junit-jupiter-api", "java/lang/Thread.class");
    assertEquals(Optional.empty(), names.bundleOf("java.lang.Thread"));
    assertEquals(List.of(), looked);
  }
}
