/** Collections that stay within bounds, whatever peers send. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.net.collection;
