package org.robotui.testkit.osgi;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleException;
import org.osgi.framework.wiring.BundleWiring;

/**
 * A bundle packed from one package of the tests, so that it is a bundle like any other: with a name and a class loader
 * of its own.
 *
 * @param tests the bundle that has the classes
 * @param name of the new bundle and of the package; its activator is the class {@code BadActivator} there
 * @param headers what its manifest says besides, such as {@code Import-Package}
 */
public record PackedBundle(Bundle tests, String name, Map<String, String> headers) {
  /**
   * Copies the headers.
   *
   * @param tests the bundle that has the classes
   * @param name of the new bundle
   * @param headers of its manifest
   */
  public PackedBundle {
    headers = Map.copyOf(headers);
  }

  /**
   * Packs it.
   *
   * @return its jar
   * @throws IOException if a class cannot be read
   */
  public byte[] jar() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream jar = new JarOutputStream(bytes, manifest())) {
      for (String path : tests.adapt(BundleWiring.class)
          .listResources(name.replace('.', '/'), "*.class", BundleWiring.LISTRESOURCES_LOCAL)) {
        jar.putNextEntry(new JarEntry(path));
        try (InputStream in = tests.getResource(path).openStream()) {
          in.transferTo(jar);
        }
        jar.closeEntry();
      }
    }
    return bytes.toByteArray();
  }

  private Manifest manifest() {
    Manifest manifest = new Manifest();
    Attributes main = manifest.getMainAttributes();
    main.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    main.putValue("Bundle-ManifestVersion", "2");
    main.putValue("Bundle-SymbolicName", name);
    main.putValue("Bundle-Version", "1.0.0");
    main.putValue("Bundle-Activator", name + ".BadActivator");
    headers.forEach(main::putValue);
    return manifest;
  }

  /**
   * Packs, installs and starts it in the framework of the tests.
   *
   * @return the running bundle, for the caller to uninstall
   * @throws BundleException if it cannot be resolved or started
   * @throws IOException if a class cannot be read
   */
  public Bundle install() throws BundleException, IOException {
    Bundle bundle = tests.getBundleContext().installBundle("memory:" + name, new ByteArrayInputStream(jar()));
    bundle.start();
    return bundle;
  }
}
