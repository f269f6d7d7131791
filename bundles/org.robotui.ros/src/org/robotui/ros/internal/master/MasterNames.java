package org.robotui.ros.internal.master;

/** Resolves names as masters do: leniently, because it is not their business to refuse what nodes agreed on. */
final class MasterNames {

  private MasterNames() {}

  /** The global name that a caller means. */
  static String resolve(String caller, String name) {
    if (name.startsWith("/")) {
      return clean(name);
    }
    return name.startsWith("~") ? clean(caller + "/" + name.substring(1))
        : clean(parent(clean("/" + caller)) + "/" + name);
  }

  static String clean(String name) {
    String single = name.replaceAll("/{2,}", "/");
    return single.length() > 1 && single.endsWith("/") ? single.substring(0, single.length() - 1) : single;
  }

  /** The namespace above a global name; the root's is the root. */
  static String parent(String name) {
    int slash = name.lastIndexOf('/');
    return slash <= 0 ? "/" : name.substring(0, slash);
  }

  /** Whether a name is the namespace or lies below it. */
  static boolean contains(String namespace, String name) {
    return namespace.equals("/") || name.equals(namespace) || name.startsWith(namespace + "/");
  }
}
