/**
 * Abstract layouts: which views lie where, without a toolkit.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.layout;
