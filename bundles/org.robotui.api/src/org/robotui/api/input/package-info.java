/** What people type: one way of reading it, and one set of words for what cannot be read. */
@org.osgi.annotation.versioning.Version("1.2.0")
package org.robotui.api.input;
