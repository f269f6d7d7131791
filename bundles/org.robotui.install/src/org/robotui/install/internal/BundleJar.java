package org.robotui.install.internal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import org.osgi.framework.Constants;

/** What a jar says of the bundle that it is. */
record BundleJar(String name, String version) {
  /** A jar that is none of a bundle, with a sentence that goes on from the name of the file. */
  static final class Unusable extends Exception {
    private static final long serialVersionUID = 1L;

    Unusable(String message) {
      super(message);
    }
  }

  /** Reads the manifest, and so the directory at the end of the file, which a jar that is not whole lacks. */
  static BundleJar read(Path file) throws Unusable {
    try (JarFile jar = new JarFile(file.toFile(), false)) {
      Manifest manifest = jar.getManifest();
      String name = manifest == null ? null : manifest.getMainAttributes().getValue(Constants.BUNDLE_SYMBOLICNAME);
      if (name == null) {
        throw new Unusable("is no bundle: its manifest has no " + Constants.BUNDLE_SYMBOLICNAME);
      }
      String version = manifest.getMainAttributes().getValue(Constants.BUNDLE_VERSION);
      return new BundleJar(name.split(";")[0].strip(), version == null ? "0.0.0" : version.strip());
    } catch (IOException e) {
      throw new Unusable("is no whole jar: " + e.getMessage());
    }
  }

  String label() {
    return name + " " + version;
  }
}
