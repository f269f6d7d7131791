/**
 * What a component can be configured with, and the checked values.
 */
@org.osgi.annotation.versioning.Version("1.8.0")
package org.robotui.api.config;
